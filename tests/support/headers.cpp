// SPDX-License-Identifier: MIT
//
// Nothing but the precompiled headers, which all test programs share.
