#include "buildings/linear_structure.h"

namespace rimpact::buildings {

using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

class LinearStructure : public Structure {
public:
  LinearStructure(const BuildingModel &model, double gravity) : model_(model), gravity_(gravity) {}
  Rest at_rest() const override { return {static_displacements(model_, gravity_), static_reactions(model_, gravity_)}; }
  VectorXd start(const VectorXd &q, const VectorXd &v) override { return -model_.stiffness * q - model_.damping * v; }
  void begin_stage(const Stage &stage) override { slope_ = stage.own * model_.stiffness + model_.damping; }
  void linearise(const VectorXd &q, const VectorXd &v, const std::vector<NodeMoment> &, VectorXd &force,
                 MatrixXd &tangent) override {
    force -= model_.stiffness * q + model_.damping * v, tangent += slope_;
  }
  Power power(int, const VectorXd &v) const override { return {v.dot(model_.damping * v), 0}; }
  double stored(const VectorXd &q) const override { return 0.5 * q.dot(model_.stiffness * q); }

private:
  const BuildingModel &model_;
  double gravity_;
  MatrixXd slope_;
};

} // namespace

std::unique_ptr<Structure> linear_structure(const BuildingModel &model, double gravity) {
  return std::make_unique<LinearStructure>(model, gravity);
}

} // namespace rimpact::buildings
