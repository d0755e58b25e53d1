// SPDX-License-Identifier: MIT
// Contexts, errors and numbers. Spaces.cs has scenes and worlds.
using System;
using System.Runtime.InteropServices;

namespace Detent {

/// <summary>A failed call. Status is one of the negative constants of C.</summary>
public sealed class DetentException : Exception {
  public readonly int Status;
  public DetentException(int status)
      : base(Marshal.PtrToStringAnsi(C.detent_describe(status))) {
    Status = status;
  }
}

/// <summary>Lengths are integers in steps of 2^-16, components of directions in steps of 2^-30.
/// </summary>
public static class Number {
  public const int One = 1 << 16;
  public const int Unit = 1 << 30;

  /// <summary>A number rounded to the nearest length, ties to even.</summary>
  public static int Raw(double units) {
    return checked((int)Math.Round(units * One, MidpointRounding.ToEven));
  }
  public static double Of(int length) { return (double)length / One; }

  /// <summary>True for yes or done, false for no; throws on an error.</summary>
  public static bool Check(int status) {
    if (status < 0) throw new DetentException(status);
    return status == C.OK;
  }
}

/// <summary>Makes scenes and worlds. Disposing it destroys them.</summary>
public sealed unsafe class Context : IDisposable {
  /// <summary>The first argument of the functions of <see cref="C"/>.</summary>
  public ContextMemory* Memory { get; private set; }
  public Context() {
    Memory = (ContextMemory*)Marshal.AllocHGlobal(sizeof(ContextMemory));
    *Memory = default(ContextMemory);
    Number.Check(C.detent_open(Memory, null));
  }
  /// <summary>The default settings: two players, delay 2, prediction 8, inputs of one
  /// byte.</summary>
  public static SessionSettings DefaultSessionSettings() {
    SessionSettings settings;
    Number.Check(C.detent_session_default_settings(&settings));
    return settings;
  }
  public void Dispose() {
    if (Memory == null) return;
    C.detent_close(Memory);
    Marshal.FreeHGlobal((IntPtr)Memory);
    Memory = null;
  }
}

}
