// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace detent::cli {

/// The content of the file `path` with these bytes: decompressed if it is a gzip file, otherwise
/// unchanged. Throws InputError if it is damaged or truncated, or holds more than 1 GiB.
[[nodiscard]] std::string unpacked(const std::string& path, std::string bytes);

}  // namespace detent::cli
