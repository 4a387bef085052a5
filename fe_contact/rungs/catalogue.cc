#include "fe_contact/rungs/catalogue.h"

#include "fe_contact/rungs/full.h"
#include "fe_contact/rungs/rigid_dish.h"
#include "fe_contact/rungs/rim.h"
#include "io/files/error.h"

namespace rimpact::fe {
namespace {

const Rung *const catalogue[] = {
    &rungs::rim,
    &rungs::rigid_dish,
    &rungs::full,
};

} // namespace

const Rung &rung_of(scene::Rung name) {
  for (const Rung *rung : catalogue)
    if (name == rung->name) return *rung;
  throw InputError("rung '" + word(name) + "' is not in this build");
}

} // namespace rimpact::fe
