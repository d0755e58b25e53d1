// SPDX-License-Identifier: MIT
//
// Start-up code of a Cortex-M for qemu. cortex_m.ld has the memory map.

#include "semihosting.hpp"

std::intptr_t semihost(std::intptr_t operation, const void* argument) {
  register std::intptr_t r0 __asm__("r0") = operation;
  register const void* r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

extern "C" {

extern std::uint32_t data_image[], data_begin[], data_end[], bss_begin[], bss_end[], stack_top[];

[[noreturn]] void reset() {
#ifdef __ARM_FP
  // Without access to coprocessors 10 and 11 the first floating-point instruction faults.
  auto* const coprocessor_access = reinterpret_cast<volatile std::uint32_t*>(0xe000ed88);
  *coprocessor_access = *coprocessor_access | 0x00f00000;
  __asm__ volatile("dsb\n\tisb");
#endif
  const std::uint32_t* from = data_image;
  for (std::uint32_t* to = data_begin; to != data_end; ++to) *to = *from++;
  for (std::uint32_t* to = bss_begin; to != bss_end; ++to) *to = 0;
  verify_and_leave();
}

[[noreturn]] void fault() { report_fault(); }

using Handler = void (*)();

struct VectorTable {
  const void* initial_stack;
  Handler on_reset;
  Handler others[14];
};

[[gnu::section(".vectors"), gnu::used]] const VectorTable vectors = {
    stack_top,
    reset,
    {fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
     fault}};

}  // extern "C"
