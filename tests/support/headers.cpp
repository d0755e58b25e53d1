// SPDX-License-Identifier: MIT
//
// Only the precompiled headers that all test programs share.
