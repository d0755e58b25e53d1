// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace detent::cli {

/// The content of the file `path`, whose bytes these are: unpacked if it is one of gzip, else as they
/// are. Throws InputError if they are damaged or cut off, or hold more than 1 GiB.
[[nodiscard]] std::string unpacked(const std::string& path, std::string bytes);

}  // namespace detent::cli
