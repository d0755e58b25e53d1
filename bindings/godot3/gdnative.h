/* SPDX-License-Identifier: MIT */
/* The parts of Godot 3's GDNative interface, version 1.0, that detent_godot.c needs. Every Godot 3
 * has that version, but Debian has no headers for it. The numbers are indices into the engine's
 * function table, in the order of https://github.com/godotengine/godot-headers
 * (gdnative_api_struct.gen.h, tag 3.x). `godot_gdnative_init` checks them. */
#ifndef DETENT_GDNATIVE_H
#define DETENT_GDNATIVE_H

#include <stdbool.h>
#include <stdint.h>

typedef struct {
  uint8_t opaque[24];
} godot_variant;
typedef struct {
  uint8_t opaque[sizeof(void*)];
} godot_array;
typedef struct {
  uint8_t opaque[sizeof(void*)];
} godot_pool_byte_array;

/* The engine's function table. */
typedef struct {
  unsigned type, major, minor;
  const void* next;
  unsigned extension_count;
  const void* const* extensions;
  void (*functions[744])(void);
} godot_core;

/* What the engine passes to a library on loading it. */
typedef struct {
  bool in_editor;
  uint64_t core_hash, editor_hash, no_hash;
  void (*report_version_mismatch)(const void*, const char*, uint64_t, uint64_t);
  void (*report_loading_error)(const void* library, const char* what);
  void* library;
  const godot_core* core;
  const void* path;
} godot_options;

enum {
  POOL_BYTE_ARRAY_NEW = 155,
  POOL_BYTE_ARRAY_APPEND = 158,
  POOL_BYTE_ARRAY_GET = 168,
  POOL_BYTE_ARRAY_SIZE = 169,
  POOL_BYTE_ARRAY_DESTROY = 170,
  ARRAY_NEW = 323,
  ARRAY_OPERATOR_INDEX = 334,
  ARRAY_APPEND = 336,
  ARRAY_SIZE = 356,
  ARRAY_DESTROY = 361,
  VARIANT_GET_TYPE = 507,
  VARIANT_NEW_INT = 512,
  VARIANT_NEW_ARRAY = 529,
  VARIANT_NEW_POOL_BYTE_ARRAY = 530,
  VARIANT_AS_INT = 539,
  VARIANT_AS_POOL_BYTE_ARRAY = 557,
  VARIANT_DESTROY = 570,
  PRINT_ERROR = 741
};

/* The types of variants. */
enum { VARIANT_BOOL = 1, VARIANT_INT = 2, VARIANT_POOL_BYTE_ARRAY = 20 };

#endif
