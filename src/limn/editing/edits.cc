// SPDX-License-Identifier: BSD-3-Clause
#include "limn/editing/edits.h"

#include <iterator>

namespace limn {
namespace {

// Adds a shift to everything in space that an edit names.
struct Mover {
  const Eigen::Vector3d& shift;

  void operator()(LinkRef& link) const {
    for (Eigen::Vector3d& point : link.points) point += shift;
  }
  void operator()(PlaceRef& place) const {
    (*this)(place.link);
    place.at += shift;
  }
  void operator()(DeleteLinks& edit) const { MoveAll(edit.links); }
  void operator()(RestoreLinks& edit) const { MoveAll(edit.links); }
  void operator()(SetLinkKind& edit) const { MoveAll(edit.links); }
  void operator()(SplitLink& edit) const { (*this)(edit.place); }
  void operator()(JoinEnds& edit) const {
    for (EndRef& end : edit.ends) (*this)(end.link);
  }
  void operator()(MergeLinks& edit) const { MoveAll(edit.links); }
  void operator()(AddDimension& edit) const {
    (*this)(edit.from);
    (*this)(edit.to);
  }
  void operator()(RemoveDimension& edit) const {
    edit.from += shift;
    edit.to += shift;
  }

 private:
  template <typename Links>
  void MoveAll(Links& links) const {
    for (LinkRef& link : links) (*this)(link);
  }
};

}  // namespace

const char* EditName(const Edit& edit) {
  constexpr const char* kNames[] = {"delete", "restore", "set_kind",  "split",
                                    "join",   "merge",   "dimension", "remove_dimension"};
  static_assert(std::size(kNames) == std::variant_size_v<Edit>);
  return kNames[edit.index()];
}

std::vector<Edit> Moved(std::vector<Edit> edits, const Eigen::Vector3d& shift) {
  for (Edit& edit : edits) std::visit(Mover{shift}, edit);
  return edits;
}

}  // namespace limn
