// SPDX-License-Identifier: MIT
//
// Start-up code of a RISC-V core: in machine mode on qemu's `virt` board (with -DMACHINE_MODE), or
// as a program for qemu-riscv32 whose only system call is semihosting.

#include "semihosting.hpp"

std::intptr_t semihost(std::intptr_t operation, const void* argument) {
  register std::intptr_t a0 __asm__("a0") = operation;
  register const void* a1 __asm__("a1") = argument;
  // The debugger recognises these three instructions if they are uncompressed and within one page.
  __asm__ volatile(
      ".option push\n\t.option norvc\n\t.balign 16\n\t"
      "slli x0, x0, 0x1f\n\tebreak\n\tsrai x0, x0, 7\n\t"
      ".option pop"
      : "+r"(a0)
      : "r"(a1)
      : "memory");
  return a0;
}

extern "C" {

extern std::uint32_t bss_begin[], bss_end[];

[[noreturn, gnu::used]] void run() {
  for (std::uint32_t* to = bss_begin; to != bss_end; ++to) *to = 0;
  verify_and_leave();
}

[[noreturn, gnu::used, gnu::aligned(4)]] void trap() { report_fault(); }

}  // extern "C"

#ifdef MACHINE_MODE
#define SET_TRAP_HANDLER "  .option arch, +zicsr\n  la t0, trap\n  csrw mtvec, t0\n"
#ifdef __riscv_flen
#define ENABLE_FPU "  li t0, 0x2000\n  csrs mstatus, t0\n"
#else
#define ENABLE_FPU ""
#endif
#else
#define SET_TRAP_HANDLER ""
#define ENABLE_FPU ""
#endif

__asm__(
    ".section .text.start, \"ax\"\n"
    ".global _start\n"
    "_start:\n" SET_TRAP_HANDLER ENABLE_FPU
    "  .option push\n"
    "  .option norelax\n"
    "  la gp, __global_pointer$\n"
    "  .option pop\n"
    "  la sp, stack_top\n"
    "  call run\n"
    ".text\n");
