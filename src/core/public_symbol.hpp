// SPDX-License-Identifier: Apache-2.0
// KERF_PUBLIC marks what the library libkerf.so shows to other programs (docs/cpp.md); the rest is
// hidden.
#pragma once

#if defined(__GNUC__)
#define KERF_PUBLIC [[gnu::visibility("default")]]
#else
#define KERF_PUBLIC
#endif
