// A name with everything that LinuxCNC takes for the same: the label of a block, a sub in all files of its runs, a
// parameter in its sub or in all programs. A rename changes these places, and puts no name where another one is.
#pragma once

#include <string>
#include <vector>

#include "analyzer/lsp/places.h"

namespace owlint::lsp {

/// Answers a request with an error that says why.
[[noreturn]] void refuse(const std::string& why);

/// Whether a name is a number: `100`, as in `o100` and `#100`.
bool is_number(std::string_view name);

class Naming {
 public:
  /// Throws ResponseError where the name cannot be changed, whatever the new one is.
  Naming(Workspace& workspace, const Document& document, Target target, uint64_t offset);

  /// Throws ResponseError where `name` has another meaning already.
  void require_free(const std::string& name) const;
  /// What has to be changed together.
  const std::vector<Occurrence>& places() const { return places_; }
  const std::string& old_name() const { return target_.name; }
  /// Of a sub, where it is defined.
  const Sub& sub() const { return sub_; }
  /// `line 4`, or `line 4 of face.ngc`.
  std::string place(const Document& in, uint64_t offset) const;
  /// A name as a machinist would write it: `o100`, `#<depth>`.
  std::string text(const std::string& name) const;

 private:
  void find_block();
  void find_sub_of_run();
  void find_parameter(uint64_t offset);
  std::vector<Occurrence> uses(const std::string& name) const;
  std::vector<Occurrence> block_labels(const Document& in, const std::string& name) const;

  // Whether something that no rename can change may mean `name`: each throws.
  void require_ours(const std::string& name) const;
  void require_no_computed_label(const std::string& name) const;
  void require_no_other_call(const std::string& name) const;
  void require_parameter_of_programs(const std::string& name) const;
  void require_no_computed_number(const std::string& name) const;
  void require_not_read_in_passing(const std::string& name) const;
  void require_not_given() const;
  bool prints(RegionId region) const;
  bool set_first(RegionId region) const;

  Workspace& workspace_;
  const Document& document_;
  Target target_;
  std::vector<const Document*> documents_;  ///< in which the name means the same
  std::optional<RegionId> region_;          ///< and only there
  Sub sub_;
  std::vector<Occurrence> places_;
  std::vector<std::shared_ptr<const MachineSetup>> machines_;  ///< of the INIs that may name it
};

}  // namespace owlint::lsp
