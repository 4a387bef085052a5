/// The fields of what the drives keep in checkpoints. Whoever writes or reads a state calls start_afresh_at.
#pragma once
#include "fe_contact/drive/motion.h"
#include "fe_contact/drive/rim_hand_over.h"
#include "fe_contact/drive/state_visitor.h"
#include "fe_contact/drive/top_drive.h"
#include "responses/summary.h"

namespace rimpact::fe {

/// Into a state of the same system: what is of another mesh is damaged.
void visit(StateVisitor &v, SystemState &state);
void visit(StateVisitor &v, MotionPoint &point);
void visit(StateVisitor &v, EnergyLedger &ledger);
void visit(StateVisitor &v, Impact &impact);
void visit(StateVisitor &v, std::vector<Impact> &impacts);
/// `n`: equations of the system that it drives.
void visit(StateVisitor &v, TopDrive &drive, Eigen::Index n);
/// `n`: dofs of the mesh.
void visit(StateVisitor &v, HeldRim &rim, Eigen::Index n);

} // namespace rimpact::fe
