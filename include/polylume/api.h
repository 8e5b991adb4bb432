/* SPDX-FileCopyrightText: 2026 The Polylume authors
 * SPDX-License-Identifier: MIT */

#ifndef POLYLUME_API_H
#define POLYLUME_API_H

/* What a host program sees of the library; everything else is hidden in it. */
#if defined(__GNUC__)
#define POLYLUME_API __attribute__((visibility("default")))
#else
#define POLYLUME_API
#endif

#endif
