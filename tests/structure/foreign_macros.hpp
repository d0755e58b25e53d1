// SPDX-License-Identifier: MIT
//
// Macros of third-party headers, for foreign_macros.sh. `min` and `max` are function-like, as in
// windows.h. Public names such as `Aabb::min` survive those, because the headers never call `min`
// or `max` in a form that the macro would expand. An object-like `min` would rename the public
// member, so it is not included here.

// windows.h
#define near
#define far
#define NEAR
#define FAR
#define small char
#define hyper long
#define interface struct
#define pascal
#define cdecl
#define IN
#define OUT
#define OPTIONAL
#define CONST const
#define VOID void
#define TRUE 1
#define FALSE 0
#define ERROR 0
#define DELETE 1
#define STRICT 1
#define ABSOLUTE 1
#define RELATIVE 2
#define TRANSPARENT 1
#define OPAQUE 2
#define Yield()
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))

// Arduino.h
#define HIGH 1
#define LOW 0
#define INPUT 0
#define OUTPUT 1
#define CHANGE 1
#define DEFAULT 1
#define DISPLAY 1
#define SERIAL 0
#define PI 3.14
#define HALF_PI 1.57
#define TWO_PI 6.28
#define EULER 2.72
#define B0 0
#define B1 1
#define B00 0
#define B01 1
#define B10 2
#define B11 3
#define F(text) (text)
#define bit(b) (1UL << (b))
#define bitRead(value, bit) (((value) >> (bit)) & 1)
#define bitSet(value, bit) ((value) |= (1UL << (bit)))
#define bitClear(value, bit) ((value) &= ~(1UL << (bit)))
#define radians(deg) ((deg)*0.0174)
#define degrees(rad) ((rad)*57.3)
#define sq(x) ((x) * (x))
#define constrain(x, low, high) ((x) < (low) ? (low) : ((x) > (high) ? (high) : (x)))
#define lowByte(w) ((w)&0xff)
#define highByte(w) ((w) >> 8)
#define interrupts()
#define noInterrupts()

// <complex.h> of C, termios.h, ctype.h, sys/sysmacros.h
#define I _Complex_I
#define B50 1
#define ECHO 8
#define _A 1
#define _B 2
#define _C 4
#define _L 8
#define _N 16
#define _P 32
#define _S 64
#define _U 128
#define _X 256
#define major(device) ((device) >> 8)
#define minor(device) ((device)&0xff)

// AssertMacros.h of macOS, X11/X.h, Qt
#define check(x)
#define verify(x)
#define require(x)
#define Always 2
#define Above 0
#define Below 1
#define Bool int
#define Complex 0
#define Convex 2
#define None 0L
#define Status int
#define Success 0
#define True 1
#define False 0
#define Unsorted 0
#define signals public
#define slots
#define emit
#define foreach for
#define forever for (;;)
