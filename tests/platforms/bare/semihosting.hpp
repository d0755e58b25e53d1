// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// Semihosting: the program traps into the debugger or emulator with an operation and the address of
// its arguments.
//
// source: Arm, Semihosting for AArch32 and AArch64; RISC-V Semihosting, which shares its numbers

/// The trap instruction of this machine; each start-up file defines it.
std::intptr_t semihost(std::intptr_t operation, const void* argument);

/// Runs the program under test and ends the emulation with its status.
[[noreturn]] void verify_and_leave();

/// Reports a processor fault and ends the emulation.
[[noreturn]] void report_fault();
