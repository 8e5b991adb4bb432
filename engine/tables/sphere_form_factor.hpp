// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

namespace polylume::tables {

/// The form factor, 0 to 1, of the part of a sphere above the horizon. `cosine` is that of the
/// angle from the normal to the sphere's middle, -1 to 1; `sine` is that of half the angle it
/// spans, 0 to 1 (Snyder 1996, "Area light sources for real-time graphics", MSR-TR-96-11).
double sphereFormFactor(double cosine, double sine);

/// What clipping at the horizon leaves: the form factor over `length`, the length sin^2 of the
/// vector form factor of the whole sphere, 0 to 1; the limit where `length` is 0. Renderers
/// multiply it by the length again (Hill and Heitz 2016, "Real-time area lighting: a journey from
/// research to production").
double sphereHorizonRatio(double cosine, double length);

}  // namespace polylume::tables
