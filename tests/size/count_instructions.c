/* SPDX-License-Identifier: MIT
 *
 * A plugin of qemu that counts the instructions a program executes between two `yield`s, which
 * compilers for Thumb and AArch64 never emit on their own. usage: -plugin count_instructions.so,to=FILE
 *
 * Debian has no header of qemu's plugin interface, so the parts used of its version 1 are declared
 * here.
 *
 * source: QEMU 7.2, docs/devel/tcg-plugins.rst */

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

typedef uint64_t qemu_plugin_id_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t,
                                           void (*)(qemu_plugin_id_t, struct qemu_plugin_tb*));
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t, void (*)(qemu_plugin_id_t, void*), void*);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb*);
struct qemu_plugin_insn* qemu_plugin_tb_get_insn(const struct qemu_plugin_tb*, size_t);
const void* qemu_plugin_insn_data(const struct qemu_plugin_insn*);
size_t qemu_plugin_insn_size(const struct qemu_plugin_insn*);
enum { add_immediate = 0, no_registers = 0 };
void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn*, int, void*, uint64_t);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn*, void (*)(unsigned, void*),
                                            int, void*);

#define EXPORT __attribute__((visibility("default")))
EXPORT int qemu_plugin_version = 1;

static FILE* out;
static uint64_t count, count_at_start;
static int is_counting;

static void mark(unsigned cpu, void* data) {
  (void)cpu, (void)data;
  if (is_counting) fprintf(out, "%llu\n", (unsigned long long)(count - count_at_start));
  is_counting = !is_counting;
  count_at_start = count;
}

static void instrument(qemu_plugin_id_t id, struct qemu_plugin_tb* block) {
  (void)id;
  for (size_t i = 0; i < qemu_plugin_tb_n_insns(block); ++i) {
    struct qemu_plugin_insn* instruction = qemu_plugin_tb_get_insn(block, i);
    const size_t size = qemu_plugin_insn_size(instruction);
    const void* data = qemu_plugin_insn_data(instruction);
    const int is_yield = (size == 2 && memcmp(data, "\x10\xbf", 2) == 0) ||
                         (size == 4 && memcmp(data, "\x3f\x20\x03\xd5", 4) == 0);
    if (is_yield) {
      qemu_plugin_register_vcpu_insn_exec_cb(instruction, mark, no_registers, NULL);
    } else {
      qemu_plugin_register_vcpu_insn_exec_inline(instruction, add_immediate, &count, 1);
    }
  }
}

static void finish(qemu_plugin_id_t id, void* data) {
  (void)id, (void)data;
  fclose(out);
}

EXPORT int qemu_plugin_install(qemu_plugin_id_t id, const void* info, int argc, char** argv) {
  (void)info;
  if (argc != 1 || strncmp(argv[0], "to=", 3) != 0) return 1;
  out = fopen(argv[0] + 3, "w");
  if (out == NULL) return 1;
  qemu_plugin_register_vcpu_tb_trans_cb(id, instrument);
  qemu_plugin_register_atexit_cb(id, finish, NULL);
  return 0;
}
