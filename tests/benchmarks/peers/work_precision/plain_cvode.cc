#include "problem.h"
#include "reduced_models/motion/sundials.h"
#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>

namespace rimpact::work_precision {
namespace {

struct Call {
  const Problem &problem;
  scene::GroundMotion ground;
};

int rhs(double t, N_Vector y, N_Vector dy, void *user) {
  const auto &call = *static_cast<Call *>(user);
  call.problem.rhs(call.ground, t, N_VGetArrayPointer(y), N_VGetArrayPointer(dy));
  return 0;
}

void check(int flag) {
  if (flag < 0) throw std::runtime_error(std::string("CVODE: ") + CVodeGetReturnFlagName(flag));
}

} // namespace

Solution plain_cvode(const Problem &problem, double tolerance) {
  const std::clock_t begin = std::clock();
  Call call{problem, scene::GroundMotion(problem.excitation, problem.gravity)};
  SUNContext context = reduced::sundials_context();
  N_Vector y = N_VNew_Serial(6, context);
  N_VConst(0.0, y);
  SUNMatrix matrix = SUNDenseMatrix(6, 6, context);
  SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, context);
  void *memory = CVodeCreate(CV_BDF, context);
  check(CVodeInit(memory, rhs, 0.0, y));
  check(CVodeSetUserData(memory, &call));
  check(CVodeSStolerances(memory, tolerance, tolerance));
  check(CVodeSetLinearSolver(memory, solver, matrix));
  check(CVodeSetMaxNumSteps(memory, 100'000'000));
  check(CVodeSetMaxStep(memory, 0.01)); // or it steps over an impact
  Solution solution;
  double t = 0;
  const long n = std::lround(problem.duration / problem.output_step);
  for (long i = 0; i <= n; ++i) {
    if (i > 0) check(CVode(memory, static_cast<double>(i) * problem.output_step, y, &t, CV_NORMAL));
    solution.x.push_back(NV_Ith_S(y, 0)), solution.y.push_back(NV_Ith_S(y, 1));
  }
  CVodeFree(&memory);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  N_VDestroy(y);
  SUNContext_Free(&context);
  solution.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return solution;
}

} // namespace rimpact::work_precision
