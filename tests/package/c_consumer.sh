#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: c_consumer.sh PREFIX
# Builds and runs the first C program of docs/bindings.md against an installation: with find_package
# and the shared or static library, and with pkg-config. Requesting a missing component is an error.
set -euo pipefail
compiler=$(command -v gcc || command -v cc) || { echo 'skipped: no C compiler is installed'; exit 77; }
prefix=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
bash tests/docs/block.sh docs/bindings.md c >"$work/main.c"
cat >"$work/CMakeLists.txt" <<'EOF'
cmake_minimum_required(VERSION 3.23)
project(consumer LANGUAGES C CXX)
find_package(detent REQUIRED COMPONENTS c c_static ${MORE})
add_executable(shared main.c)
target_link_libraries(shared PRIVATE detent::c)
add_executable(static main.c)
target_link_libraries(static PRIVATE detent::c_static)
EOF
configure() {
  cmake -S "$work" -B "$1" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF \
    "${@:2}" >"$work/log" 2>&1
}
configure "$work/build" || { cat "$work/log"; exit 1; }
cmake --build "$work/build" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
programs=("$work/build/shared" "$work/build/static")
if configure "$work/none" -DMORE=wheels; then
  echo 'find_package accepts a missing component'
  exit 1
fi
grep -q 'no component wheels' "$work/log" || { cat "$work/log"; exit 1; }

PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name detent.pc)")
export PKG_CONFIG_PATH
if command -v pkg-config >/dev/null; then
  read -ra flags < <(pkg-config --cflags --libs detent)
  library=$(pkg-config --variable=libdir detent)
  "$compiler" "$work/main.c" "${flags[@]}" -Wl,-rpath,"$library" -o "$work/by_pkg_config"
  programs+=("$work/by_pkg_config")
fi
for program in "${programs[@]}"; do
  said=$("$program")
  [[ $said == 'object 0 at 9.000000' ]] || { echo "$(basename "$program") prints $said"; exit 1; }
done
echo "${#programs[@]} programs use the installation"
