// SPDX-License-Identifier: Apache-2.0
// The faces of a solid, on which water acts along their normals (fluid/smooth_wall.hpp), turn with
// its deformation. A face that was N / delta before, with the unit normal N and the depth delta of
// the particle below it, is
//   n / depth = F^-T N / delta = cof F N / (delta det F)
// at the deformation gradient F, and its area is |cof F N| times what it was (Ogden, Non-linear
// Elastic Deformations, 1984, section 2.2.3). A particle that is damaged has no face: water beside
// a crack acts along the lines of centres.
#pragma once

#include <cmath>

#include "core/matrix.hpp"
#include "solid/body_load.hpp"
#include "standard/open_damaged.hpp"

namespace kerf {

template <int D, class P>
struct TurnFaces {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  SolidIndexView link;
  SolidView<D, P> solid;
  // Of each particle, where ranks divide the solid: the deformation gradient less 1, and IsDamaged.
  const Matrix<D, Real>* gradient = nullptr;
  const Real* damaged = nullptr;
  static constexpr double least_volume = 0.05;  // det F; with less it has collapsed

  KERF_FUNCTION void operator()(Index s) const {
    const Index i = link.particle_of[s];
    if (i == no_index || particles.fractured[i]) return;
    const auto& at_rest = particles.face_at_rest[i];
    if (!(dot(at_rest, at_rest) > Real(0))) return;
    particles.face_normal[i] = particles.face_corner[i] = Vector<D, Real>::zero();
    if ((damaged != nullptr ? damaged[s] : IsDamaged<D, P>{solid}(s)) > Real(0)) return;
    const Matrix<D, Real>& h = gradient != nullptr ? gradient[s] : solid.gradient[s];
    const Real volume = determinant(identity<D, Real>() + h);
    if (!(volume > Real(least_volume))) return;
    const auto turned = cofactor(h) * Vector<D, double>::from(at_rest);
    const auto face = Vector<D, Real>::from((1.0 / double(volume)) * turned);
    const auto& corner = particles.corner_at_rest[i];
    const Real square = dot(corner, corner);
    particles.face_depth[i] = std::sqrt(Real(1) - square) / norm(face);
    particles.face_normal[i] = particles.face_depth[i] * face;
    if (square > Real(0)) particles.face_corner[i] = turned_corner(cofactor(h), corner, turned);
    const double area = norm(turned) / double(norm(at_rest));
    particles.face_growth[i] = static_cast<Real>((D == 2 ? area : std::sqrt(area)) - 1.0);
  }

 private:
  // The normals n + c and n - c of two faces keep the angle between them: c turns as a normal does,
  // and stays normal to n.
  template <class Cofactor>
  KERF_FUNCTION static Vector<D, Real> turned_corner(const Cofactor& cofactor,
                                                     const Vector<D, Real>& corner,
                                                     const Vector<D, double>& normal) {
    const auto at_rest = Vector<D, double>::from(corner);
    auto turned = cofactor * at_rest;
    turned = turned - (dot(turned, normal) / dot(normal, normal)) * normal;
    const double length = norm(turned);
    if (!(length > 0.0)) return Vector<D, Real>::zero();
    return Vector<D, Real>::from((norm(at_rest) / length) * turned);
  }
};

}  // namespace kerf
