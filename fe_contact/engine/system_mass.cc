#include "fe_contact/engine/system_mass.h"

#include "fe_contact/solver/ranks.h"
#include <stdexcept>

namespace rimpact::fe {

SystemMass::SystemMass(const Solid &solid, const Equations &equations,
                       const std::vector<std::pair<int, double>> &bodies)
    : whole_(solid.mass(equations)) {
  if (ranks().size > 1) own_.emplace(solid.own_mass(equations));
  for (const auto &[dof, mass] : bodies)
    for (int i = 0; i < 3; ++i)
      if (const int equation = equations.of_dof[dof + i]; equation >= 0) {
        whole_.add(equation, equation, mass);
        if (own_ && ranks().first()) own_->add(equation, equation, mass);
      }
}

void SystemMass::find_places(const SymmetricMatrix &tangent) {
  places_.clear();
  const auto &offsets = own().offsets(), &columns = own().columns();
  for (std::size_t row = 0; row + 1 < offsets.size(); ++row)
    for (int k = offsets[row]; k < offsets[row + 1]; ++k)
      if (places_.push_back(tangent.find(static_cast<int>(row), columns[k])); places_.back() < 0)
        throw std::logic_error("a mass outside the tangent's sparsity pattern");
}

void SystemMass::put(double factor, SymmetricMatrix &tangent) const {
  for (std::size_t k = 0; k < places_.size(); ++k) tangent.values()[places_[k]] = factor * own().values()[k];
}

} // namespace rimpact::fe
