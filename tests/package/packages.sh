#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: packages.sh BUILD KIND
# Installs a package made by packages/build in an empty folder, with the package manager of its kind, and
# runs the program of its README there. KIND is a kind of packages/build, or `recipes` for vcpkg and Conan.
set -euo pipefail
build=$1 kind=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
version=$(sed -n 's/#define DETENT_VERSION_[A-Z]* //p' include/detent/version.hpp | paste -sd .)
block=$(realpath tests/docs/block.sh)
expect() {
  if [[ $1 != "$2" ]]; then echo "the program of its README prints '$1' instead of '$2'"; exit 1; fi
  echo "the $kind package works from an empty folder"
}
# package PATTERN: makes the package and prints its file name.
package() {
  packages/build "$build" "$work/packages" "$kind" >"$work/log" || { cat "$work/log" >&2; exit 1; }
  local found=("$work/packages/"$1)
  if [[ ! -e ${found[0]} ]]; then cat "$work/log" >&2; exit 77; fi
  echo "${found[0]}"
}

case $kind in
  deb)
    file=$(package "libdetent-dev_${version}_*.deb")
    # dpkg installs it in an empty root, without the packages it depends on. The root has no shell for
    # the package's script, which runs ldconfig; so the script runs outside, with an ldconfig that does nothing.
    database=$work/root/var/lib/dpkg
    mkdir -p "$database/info" "$database/updates" "$work/bin"
    touch "$database/status"
    ln -s "$(type -P true)" "$work/bin/ldconfig"
    PATH=$work/bin:$PATH dpkg --root="$work/root" --log=/dev/null --force-depends --force-not-root \
      --force-bad-path --force-script-chrootless --install "$file" >"$work/log" 2>&1 ||
      { cat "$work/log"; exit 1; }
    said=$(dpkg-query --admindir="$database" --show --showformat '${Status} ${Version}' libdetent-dev)
    [[ $said == "install ok installed $version" ]] || { echo "dpkg says: $said"; exit 1; }
    bash tests/package/c_consumer.sh "$work/root/usr"
    bash tests/package/readme.sh "$work"/root/usr/share/doc/*/README.md "$work/root/usr"
    ;;
  wheel)
    file=$(package "detent-$version-*.whl")
    if python3 -m pip --version >/dev/null 2>&1; then
      python3 -m pip install --quiet --no-index --no-deps --no-compile --disable-pip-version-check \
        --root-user-action=ignore --target "$work/site" "$file"
    else
      python3 -m zipfile -e "$file" "$work/site"
    fi
    bash "$block" "$work"/site/detent-*.dist-info/METADATA python >"$work/page.py"
    expect "$(cd "$work" && env -u DETENT_LIBRARY PYTHONPATH="$work/site" python3 page.py)" 'True 9.0'
    ;;
  crate)
    file=$(package "detent-$version.crate")
    tar -xzf "$file" -C "$work"
    mkdir -p "$work/user/src"
    bash "$block" "$work/detent-$version/README.md" rust | sed 's/^    Ok(())$/    println!("ran"); Ok(())/' >"$work/user/src/main.rs"
    printf '%s\n' '[package]' 'name = "user"' 'version = "1.0.0"' 'edition = "2021"' '[dependencies]' \
      "detent = { path = \"$work/detent-$version\" }" >"$work/user/Cargo.toml"
    library=$(realpath "$build/src/c")
    export DETENT_LIBRARY_DIR=$library LD_LIBRARY_PATH=$library
    expect "$(cd "$work/user" && cargo run --offline --quiet)" ran
    ;;
  npm)
    file=$(package "detent-$version.tgz")
    mkdir "$work/user"
    cd "$work/user"
    npm install --silent --offline --no-audit --no-fund "$file" >/dev/null
    bash "$block" node_modules/detent/README.md js >page.mjs
    expect "$(node page.mjs)" 9
    ;;
  recipes)
    python3 tests/package/recipes.py "$build" "$version"
    ;;
esac
