#include "analyzer/program/linker.h"

#include <algorithm>

#include "analyzer/text/paths.h"

namespace owlint {
namespace {

// A call in a file is at most nine levels deep, so that a file which is further away is never reached.
constexpr int kMaxDistance = 10;
constexpr size_t kMaxFiles = 4096;

/// Copies one file's syntax and structure after those that are joined already.
class Joiner {
 public:
  explicit Joiner(Program& out) : out_(out) {}

  void append(const Program& in, bool last) {
    names(in);
    statement0_ = static_cast<uint32_t>(out_.syntax.statements.size());
    value0_ = static_cast<uint32_t>(out_.syntax.values.size());
    item0_ = static_cast<uint32_t>(out_.syntax.items.size());
    error0_ = static_cast<uint32_t>(out_.syntax.errors.size());
    word0_ = static_cast<uint32_t>(out_.syntax.mode_words.size());
    expr0_ = static_cast<uint32_t>(out_.syntax.exprs.size());
    region0_ = static_cast<uint32_t>(out_.regions.size());
    block0_ = static_cast<uint32_t>(out_.blocks.size());
    syntax(in.syntax);
    out_.syntax.runs_python = out_.syntax.runs_python || in.syntax.runs_python;
    structure(in);
    if (last) return;
    Statement end;
    end.kind = LineKind::kFileEnd;
    out_.syntax.statements.push_back(end);
    out_.region_of.push_back(region0_);
    out_.block_of.push_back(kNoBlock);
  }

 private:
  static uint32_t moved(uint32_t id, uint32_t by) { return id == UINT32_MAX ? id : id + by; }
  NameId name(NameId id) const { return id == kNoName ? id : names_[id]; }
  StatementId statement(StatementId id) const { return moved(id, statement0_); }
  ExprId expr(ExprId id) const { return moved(id, expr0_); }
  BlockId block(BlockId id) const { return moved(id, block0_); }

  void names(const Program& in) {
    names_.clear();
    for (NameId id = 0; id < in.syntax.names.size(); ++id) names_.push_back(out_.syntax.names.intern(in.name(id)));
  }

  /// By how much the place that Statement::first names has moved.
  uint32_t first_moves(const Statement& s) const {
    switch (s.kind) {
      case LineKind::kUserCode: return 0;
      case LineKind::kMachineCheck: return error0_;
      case LineKind::kModeLine:
      case LineKind::kRemap: return word0_;
      default: return s.has_items() ? item0_ : value0_;
    }
  }

  void syntax(const Syntax& in) {
    Syntax& out = out_.syntax;
    for (Statement s : in.statements) {
      s.label = name(s.label);
      s.label_expr = expr(s.label_expr);
      s.first += first_moves(s);
      s.error = moved(s.error, error0_);
      out.statements.push_back(s);
    }
    for (const ExprId value : in.values) out.values.push_back(expr(value));
    for (Item item : in.items) {
      item.value = expr(item.value);
      item.target = expr(item.target);
      item.target_name = name(item.target_name);
      out.items.push_back(item);
    }
    for (ModeWord word : in.mode_words) {
      word.computed = expr(word.computed);
      out.mode_words.push_back(word);
    }
    for (ModeNeed need : in.mode_needs) {
      need.after += statement0_;
      out.mode_needs.push_back(need);
    }
    out.asks_place = out.asks_place || in.asks_place;
    out.reads_place = out.reads_place || in.reads_place;
    out.writes_tools = out.writes_tools || in.writes_tools;
    for (PlaceChange change : in.place_changes) {
      change.after += statement0_;
      out.place_changes.push_back(change);
    }
    for (ModeChange change : in.mode_changes) {
      change.after += statement0_;
      out.mode_changes.push_back(change);
    }
    for (LineError error : in.errors) {
      error.first_value = expr(error.first_value);
      error.read_from += expr0_;
      error.read_to += expr0_;
      out.errors.push_back(std::move(error));
    }
    for (Expr e : in.exprs) {
      e.move([this](ExprId id) { return expr(id); }, [this](NameId id) { return name(id); });
      out.exprs.push_back(e);
    }
  }

  void structure(const Program& in) {
    for (Region r : in.regions) {
      r.name = name(r.name);
      r.opener = statement(r.opener);
      r.end = statement(r.end);
      r.early_end = statement(r.early_end);
      r.likely_end = statement(r.likely_end);
      r.enclosing = block(r.enclosing);
      r.last += statement0_;
      out_.regions.push_back(r);
    }
    for (const RegionId r : in.region_of) out_.region_of.push_back(r + region0_);
    for (Block b : in.blocks) {
      b.label = name(b.label);
      b.region += region0_;
      b.opener = statement(b.opener);
      b.end = statement(b.end);
      b.parent = block(b.parent);
      b.crossed = block(b.crossed);
      b.mistaken_end = statement(b.mistaken_end);
      out_.blocks.push_back(b);
    }
    for (const BlockId b : in.block_of) out_.block_of.push_back(block(b));
    for (Call call : in.calls) {
      call.statement = statement(call.statement);
      call.caller += region0_;
      call.callee = name(call.callee);
      call.target = moved(call.target, region0_);
      out_.calls.push_back(call);
    }
  }

  Program& out_;
  std::vector<NameId> names_;
  uint32_t statement0_ = 0, value0_ = 0, item0_ = 0, error0_ = 0, word0_ = 0, expr0_ = 0, region0_ = 0, block0_ = 0;
};

}  // namespace

std::string_view called_label(std::string_view name, Version version) {
  if (version < Version::k2_9) return name;
  return name.substr(name.rfind('/') + 1);  // all of it where there is none
}

Linked::Linked(std::shared_ptr<const Program> program, const Profile& profile, Library& library, bool notes)
    : answers_(library.search_path(program->source->path(), profile), notes), library_(library), profile_(profile) {
  const std::string path = program->source->path();
  by_path_.emplace(file_key(path), 0);
  files_.push_back({as_run(std::move(program)), 0, 0, true});
  follow(0);
  join();
}

uint32_t Linked::add_file(const FoundFile& found) {
  const auto [entry, added] = by_path_.try_emplace(file_key(found.path), static_cast<uint32_t>(files_.size()));
  if (added) files_.push_back({as_run(library_.load_called(found.path, profile_)), 0, 0, found.regular});
  return entry->second;
}

std::shared_ptr<const Program> Linked::as_run(std::shared_ptr<const Program> program) const {
  return profile_.block_delete ? without_deleted_lines(std::move(program)) : program;
}

CallTarget Linked::target(const std::string& name) const {
  const auto known = targets_.find(name);
  return known == targets_.end() ? CallTarget{CallTarget::kNotFound, leaves_folders(name) || expands(name)}
                                 : known->second;
}

/// Looks up what the files from index `from` on call, level by level.
void Linked::follow(size_t from) {
  for (int distance = 0; distance < kMaxDistance && from < files_.size(); ++distance) {
    const size_t level_end = files_.size();
    for (; from < level_end; ++from) {
      const auto program = files_[from].program;
      std::vector<bool> looked(program->syntax.names.size());
      for (const Call& call : program->calls) {
        if (call.callee == kNoName || looked[call.callee] || files_.size() >= kMaxFiles) continue;
        looked[call.callee] = true;
        const std::string& name = program->name(call.callee);
        if (targets_.contains(name)) continue;
        if (const auto found = answers_.find(name)) targets_.emplace(name, CallTarget{add_file(*found), false});
      }
    }
  }
}

bool Linked::add(const std::string& name) {
  if (targets_.contains(name)) return false;
  const auto found = answers_.find(name);
  if (!found) return false;
  const size_t before = files_.size();
  targets_.emplace(name, CallTarget{add_file(*found), false});
  follow(before);
  join();
  return true;
}

void Linked::join() {
  StatementId first = 0;
  for (size_t i = 0; i < files_.size(); ++i) {
    LinkedFile& file = files_[i];
    file.first = first;
    file.last = first + static_cast<StatementId>(file.program->size());
    first = file.last + 1;
  }
  joined_.reset();
  if (files_.size() == 1) return;
  auto joined = std::make_shared<Program>();
  const Program& main = *files_[0].program;
  joined->source = main.source;
  Joiner joiner(*joined);
  for (size_t i = 0; i < files_.size(); ++i) joiner.append(*files_[i].program, i + 1 == files_.size());
  joined->syntax.percent = main.syntax.percent;
  joined->syntax.blank = main.syntax.blank;
  joined->syntax.first_changes = main.syntax.first_changes;
  joined->syntax.first_needs = main.syntax.first_needs;
  joined->syntax.left_at = main.syntax.left_at;
  joined->syntax.place_at_start = main.syntax.place_at_start;
  joined->sub_file = main.sub_file;
  joined->entry = main.entry == kNoName ? kNoName : joined->syntax.names.find(main.name(main.entry));
  index_labels(*joined);
  index_parts(*joined);
  joined_ = std::move(joined);
}

uint32_t Linked::file_of(StatementId id) const {
  const auto after = std::ranges::upper_bound(files_, id, {}, &LinkedFile::first);
  return static_cast<uint32_t>(after - files_.begin()) - 1;
}

}  // namespace owlint
