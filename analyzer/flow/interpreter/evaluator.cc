#include "analyzer/flow/interpreter/evaluator.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <memory_resource>
#include <string_view>

#include "analyzer/machine/remap_names.h"
#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {

Evaluator::Evaluator(const Syntax& syntax, const Profile& profile, const TrackedParameters& tracked,
                     RememberedConditions& remembered, KnownValues& values, PersistentMap::Pool& pool)
    : syntax_(syntax),
      profile_(profile),
      tracked_(tracked),
      remembered_(remembered),
      values_(values),
      pool_(pool),
      value_name_(syntax.names.find("_value")),
      value_returned_name_(syntax.names.find("_value_returned")) {}

void Evaluator::set_number(Parameters& p, long number, ValueId value) {
  if (number < 1 || number > kLastNumber) return;
  remembered_.forget(p, static_cast<uint32_t>(number) | (number >= kFirstGlobalNumber ? kGlobalKey : 0));
  if (!tracked_.number_matters(number)) {
    // Of an argument that only moves read, all that matters is whether it was passed.
    if (number >= kFirstGlobalNumber || !tracked_.is_read(number)) return;
    if (value != kNotPassed) value = kUnknown;
  }
  if (coarse_ && value >= kFirstConstant) value = kUnknown;
  PersistentMap& map = number < kFirstGlobalNumber ? p.locals : p.globals;
  map.set(pool_, static_cast<uint32_t>(number), value);
}

void Evaluator::set_name(Parameters& p, NameId name, ValueId value) {
  const bool global = tracked_.is_global(name);
  remembered_.forget(p, tracked_.key_of_name(name));
  // A constant that decides nothing is only "assigned".
  if (value >= kFirstConstant && (coarse_ || !tracked_.name_matters(name))) value = kUnknown;
  (global ? p.globals : p.locals).set(pool_, (global ? kGlobalNames : kLocalNames) + name, value);
}

void Evaluator::pass(Parameters& p, std::span<const ValueId> arguments) {
  const PersistentMap::Pool::Batch batch(pool_);
  for (const uint32_t n : tracked_.arguments()) set_number(p, n, n <= arguments.size() ? arguments[n - 1] : kNotPassed);
}

PersistentMap Evaluator::share_numbers(PersistentMap names, const PersistentMap& numbers) {
  for (uint32_t n = 1; n < kFirstGlobalNumber; ++n) names.set(pool_, n, numbers.get(n));
  return names;
}

void Evaluator::forget_numbers(Parameters& p) {
  for (const uint32_t number : tracked_.numbers()) set_number(p, number, kUnknown);
  p.local_outcomes = {};
  p.global_outcomes = {};
}

ValueId Evaluator::read_number(long number, const Parameters& in) const {
  if (number >= kFirstVolatileNumber) return kUnknown;
  // What does not matter has not been kept; but where numbers are read by computed ones, all that are assigned matter.
  const bool never_assigned = tracked_.computes_reads() && !tracked_.computes_targets();
  const bool local = number < kFirstGlobalNumber;
  if (!tracked_.number_matters(number) && !(local && tracked_.is_read(number)) && !never_assigned) return kUnknown;
  if (local) return in.locals.get(static_cast<uint32_t>(number));
  const ValueId value = in.globals.get(static_cast<uint32_t>(number));
  if (distrusts_globals_) return kUnknown;
  return value == kUnassigned && in.outside ? kUnknown : value;
}

bool Evaluator::always_there(NameId global) const {
  return tracked_.kind(global) >= NameKind::kOfMachine ||
      (coarse_ && (tracked_.is_assigned(global) || tracked_.is_asked_for(global)));
}

bool Evaluator::is_plain(ParameterId p, const Parameters& in) const {
  ValueId value = kUnknown;
  if (!p.named) {
    const bool local = p.id < kFirstGlobalNumber;
    value = (local ? in.locals : in.globals).get(p.id);
    return value != kNotPassed && value < kFirstConstant;
  }
  const bool global = tracked_.is_global(p.id);
  value = global ? in.globals.get(kGlobalNames + p.id) : in.locals.get(kLocalNames + p.id);
  return global ? value < kFirstConstant : value == kUnknown;
}

void Evaluator::assign_unknown(ParameterId p, bool certain, Parameters& parameters) {
  const auto value = [&](uint32_t key, bool global) {
    return certain ? kUnknown : values_.join((global ? parameters.globals : parameters.locals).get(key), kUnknown);
  };
  if (!p.named) return set_number(parameters, p.id, value(p.id, p.id >= kFirstGlobalNumber));
  const bool global = tracked_.is_global(p.id);
  set_name(parameters, p.id, value((global ? kGlobalNames : kLocalNames) + p.id, global));
}

Evaluation Evaluator::read_name(NameId name, const Parameters& in, const Reading& how) {
  Evaluation out;
  if (tracked_.is_global(name)) {
    const ValueId known = in.globals.get(kGlobalNames + name);
    const bool result = name == value_name_ || name == value_returned_name_;
    if (result && coarse_) return out;
    if (name == value_name_ && known >= kNotReturned && known <= kMaybeNotReturned) {
      if (how.log != nullptr) how.log->no_value = known;
      if (known != kMaybeNotReturned) out.value = values_.intern(0);
      return out;
    }
    const bool predefined = tracked_.kind(name) == NameKind::kPredefined && !result;
    if (const auto number = predefined ? ini_number(syntax_.names.text(name), profile_) : std::nullopt) {
      out.value = values_.intern(*number);
      return out;
    }
    if (const auto shown =
            predefined && modes_ != nullptr ? modes_->named(in, syntax_.names.text(name)) : std::nullopt) {
      out.value = values_.intern(*shown);
      return out;
    }
    if (!predefined && !distrusts_globals_ && known >= kFirstConstant) {
      out.value = known;
      return out;
    }
    // A sub from elsewhere may have assigned any, but not what LinuxCNC looks for in the INI.
    const bool from_elsewhere = in.outside && !is_ini_text(syntax_.names.text(name), profile_);
    if (from_elsewhere || always_there(name)) return out;
    out.value = distrusts_globals_ && known >= kFirstConstant ? kUnknown : known;
  } else {
    out.value = in.locals.get(kLocalNames + name);
  }
  if (out.value >= kFirstConstant || out.value == kUnknown || out.value == kNotPassed) return out;
  if (how.undefined == Undefined::kPasses) {
    // It does not stop: the value is whatever is in memory, mostly 0 or near 0 (measured).
    out.value = how.unset == Unset::kZero ? values_.intern(0) : kUnknown;
    return out;
  }
  // A global that the program assigns elsewhere is there from the second run on.
  const bool from_before = tracked_.kind(name) == NameKind::kSomeReleases ||
      (tracked_.is_global(name) && (tracked_.is_assigned(name) || tracked_.is_asked_for(name)));
  (out.value == kUnassigned && !from_before ? out.fails : out.may_fail) = StopKind::kNameUndefined;
  out.name = name;
  out.value = kUnknown;
  return out;
}

Evaluation Evaluator::exists(const Expr& expr, const Parameters& in) {
  Evaluation out;
  if (expr.op == Operator::kExistsNumbered) {
    double number = 0;
    long whole = 0;
    if (literal_value(syntax_.exprs, expr.left(), &number) && !to_integer(number, &whole)) {
      out.fails = StopKind::kParameterRange;
      out.message = "Non integer value for integer";
    }
    return out;
  }
  if (tracked_.is_global(expr.name())) {
    const ValueId value =
        tracked_.kind(expr.name()) == NameKind::kPredefined ? kUnknown : in.globals.get(kGlobalNames + expr.name());
    if (value == kUnknown || value >= kFirstConstant) out.value = values_.intern(1);
    return out;
  }
  const ValueId value = in.locals.get(kLocalNames + expr.name());
  if (value == kUnassigned) out.value = values_.intern(0);
  if (value == kUnknown || value >= kFirstConstant) out.value = values_.intern(1);
  return out;
}

// Recursion is bounded by the length of one line.
Evaluation Evaluator::evaluate(ExprId id, const Parameters& in, const Reading& how) {
  const Expr& expr = syntax_.exprs[id];
  Evaluation out;
  switch (expr.op) {
    case Operator::kNumber: out.value = values_.intern(expr.value()); return out;
    case Operator::kNamed: return read_name(expr.name(), in, how);
    case Operator::kExistsNamed:
    case Operator::kExistsNumbered: return exists(expr, in);
    default: break;
  }
  const Evaluation left = evaluate(expr.left(), in, how);
  if (left.fails != StopKind::kNone) return left;
  out.may_fail = left.may_fail;
  out.name = left.name;
  out.message = left.message;
  if (expr.op == Operator::kParameter) {
    if (!KnownValues::is_constant(left.value)) return out;
    long number = 0;
    if (!to_integer(values_.value(left.value), &number)) {
      out.fails = StopKind::kParameterRange;
      out.message = "Non integer value for integer";
    } else if (number < 1 || number > kLastNumber) {
      out.fails = StopKind::kParameterRange;
      out.message = "Parameter number out of range";
    } else if (is_position(number) && modes_ != nullptr && modes_->compensates(in)) {
      out.fails = StopKind::kCompensation;
      out.message = "Cannot read current position with cutter radius compensation on";
    } else if (const auto shown = modes_ == nullptr ? std::nullopt : modes_->numbered(in, number)) {
      out.value = values_.intern(*shown);
    } else {
      out.value = read_number(number, in);
      if (out.value == kNotPassed) {
        if (how.log != nullptr) how.log->not_passed |= 1U << number;
        out.value = values_.intern(0);
      }
      if (out.value == kUnassigned && how.unset == Unset::kZero) out.value = values_.intern(0);
      if (out.value < kFirstConstant) out.value = kUnknown;
    }
    return out;
  }
  ValueId right_value = left.value;
  if (expr.right() != kNoExpr) {
    const Evaluation right = evaluate(expr.right(), in, how);
    if (right.fails != StopKind::kNone) return out.may_fail == StopKind::kNone ? right : out;
    if (out.may_fail == StopKind::kNone) {
      out.may_fail = right.may_fail;
      out.name = right.name;
      out.message = right.message;
    }
    right_value = right.value;
  }
  if (KnownValues::is_constant(left.value) && KnownValues::is_constant(right_value)) {
    double result = 0;
    const char* message = apply(expr.op, values_.value(left.value), values_.value(right_value), &result);
    const bool within = expr.right() != kNoExpr && expr.op != Operator::kAtan && !expr.complete;
    if (message == nullptr) {
      out.value = values_.intern(result);
    } else if (!within || !is_not_finite(message)) {
      out.fails = StopKind::kValueFails;
      out.message = message;
    }
  } else if (left.value >= kFirstConstant || right_value >= kFirstConstant) {
    const Range a = values_.range(left.value);
    const Range b = values_.range(right_value);
    if (const char* message = always_fails(expr.op, a, b)) {
      out.fails = StopKind::kValueFails;
      out.message = message;
    } else {
      out.value = values_.intern(apply(expr.op, a, b));
    }
  }
  return out;
}

/// A name exists as soon as it was read before `=`, for its own value and for the rest of the line: new ones are 0 there, others
/// what they were before the line (measured).
void Evaluator::begin_name(NameId name, Parameters& p) {
  const bool global = tracked_.is_global(name);
  PersistentMap& map = global ? p.globals : p.locals;
  const uint32_t key = (global ? kGlobalNames : kLocalNames) + name;
  const ValueId before = map.get(key);
  if (before != kUnassigned && before != kMaybeUnassigned) return;
  map.set(pool_, key, global || before == kMaybeUnassigned || coarse_ ? kUnknown : values_.intern(0));
}

Evaluation Evaluator::target(double value, long* number) const {
  Evaluation out;
  if (!to_integer(value, number)) {
    out.fails = StopKind::kParameterRange;
    out.message = "Non integer value for integer";
  } else if (*number < 1 || *number > kLastNumber) {
    out.fails = StopKind::kParameterReadOnly;
    out.message = "Parameter number out of range";
  } else if (read_only(*number)) {
    out.fails = StopKind::kParameterReadOnly;
    out.message = "Parameter is readonly";
  }
  return out;
}

Evaluation Evaluator::assign(const Statement& s, Parameters& parameters, ReadLog* log) {
  const Reading how{Unset::kAny, Undefined::kStops, log};
  Evaluation may;  // the first thing that stops on some of the joined paths
  struct Assigned {
    long number;  // 0: unknown number; -1: a name
    NameId name;
    ValueId value;
  };
  std::array<std::byte, 8 * sizeof(Assigned)> room;  // for most lines
  std::pmr::monotonic_buffer_resource memory(room.data(), room.size());
  std::pmr::vector<Assigned> writes(&memory);
  writes.reserve(s.item_count);
  Parameters reading = parameters;
  for (const Item& item : syntax_.items_of(s)) {
    if (item.target_name != kNoName) begin_name(item.target_name, reading);
    Assigned write{-1, item.target_name, kUnknown};
    if (item.target != kNoExpr) {
      const Evaluation index = evaluate(item.target, reading, how);
      if (index.fails != StopKind::kNone) return may.may_fail == StopKind::kNone ? index : may;
      write.number = 0;
      if (KnownValues::is_constant(index.value)) {
        const Evaluation out = target(values_.value(index.value), &write.number);
        if (out.fails != StopKind::kNone) return may.may_fail == StopKind::kNone ? out : may;
      }
    }
    Evaluation value = evaluate(item.value, reading, how);
    if (item.letter != 0 && values_.is_constant(value.value)) {
      value.message = refused_number(item.letter, values_.value(value.value));
      if (value.message != nullptr) {
        value.fails = StopKind::kNumberOutOfRange;
        value.item = static_cast<uint8_t>(&item - syntax_.items_of(s).data());
      }
    }
    if (value.fails != StopKind::kNone) return may.may_fail == StopKind::kNone ? value : may;
    if (may.may_fail == StopKind::kNone && value.may_fail != StopKind::kNone) {
      may.may_fail = value.may_fail;
      may.name = value.name;
      may.message = value.message;
    }
    write.value = value.value;
    const bool assigns = item.target != kNoExpr || item.target_name != kNoName;
    if (!assigns) continue;
    if (item.target_name != kNoName && tracked_.kind(item.target_name) == NameKind::kPredefined &&
        may.read_only == kNoName)
      may.read_only = item.target_name;
    writes.push_back(write);
  }
  if (may.read_only != kNoName) return may;
  for (const Assigned& write : writes) {
    if (write.number == 0) {
      forget_numbers(parameters);
    } else if (write.number > 0) {
      set_number(parameters, write.number, write.value);
    } else {
      set_name(parameters, write.name, write.value);
    }
  }
  return may;
}

void Evaluator::assume_assigned(NameId name, Parameters& p) {
  const bool global = tracked_.is_global(name);
  PersistentMap& map = global ? p.globals : p.locals;
  const uint32_t key = (global ? kGlobalNames : kLocalNames) + name;
  if (const ValueId before = map.get(key); before == kUnassigned || before == kMaybeUnassigned)
    map.set(pool_, key, kUnknown);
}

void Evaluator::assume_there(NameId name, Parameters& p) {
  const bool from_before = tracked_.is_global(name) && p.globals.get(kGlobalNames + name) == kUnassigned;
  assume_assigned(name, p);
  if (!from_before) return;
  for (const NameId other : tracked_.assigned_globals()) assume_assigned(other, p);
}

std::vector<uint32_t> Evaluator::result_keys() const {
  std::vector<uint32_t> keys;
  for (const NameId name : {value_name_, value_returned_name_}) {
    if (name != kNoName) keys.push_back(kGlobalNames + name);
  }
  return keys;
}

void Evaluator::come_back(Parameters& p, const ValueId* value, bool never) {
  if (coarse_) return;  // calls are skipped there
  if (value_returned_name_ != kNoName)
    p.globals.set(pool_, kGlobalNames + value_returned_name_, values_.intern(value != nullptr ? 1 : 0));
  if (value_name_ == kNoName) return;
  const uint32_t key = kGlobalNames + value_name_;
  ValueId after = kNotReturned;
  if (value != nullptr) {
    const bool tracked = *value >= kFirstConstant && tracked_.name_matters(value_name_);
    after = tracked ? *value : kUnknown;
  } else if (const ValueId before = p.globals.get(key); never && before != kUnassigned && before != kNotReturned) {
    after = kCleared;
  }
  p.globals.set(pool_, key, after);
}

uint64_t Evaluator::machine_values() const {
  uint64_t out = 0;
  for (NameId name = 0; name < tracked_.names(); ++name) {
    const std::string_view text = syntax_.names.text(name);
    if (!may_be_predefined(text)) continue;
    out = mix(out, static_cast<uint64_t>(tracked_.kind(name)));
    if (const auto number = ini_number(text, profile_)) out = mix(out, std::bit_cast<uint64_t>(*number));
  }
  return out;
}

bool Evaluator::will_fail(std::span<const ExprId> operations, const Parameters& p) {
  return std::ranges::any_of(operations, [&](ExprId id) {
    const StopKind stop = evaluate(id, p).fails;
    return stop == StopKind::kValueFails || stop == StopKind::kParameterRange;
  });
}

void Evaluator::call_outside(Parameters& p) {
  p.outside = true;
  p.globals = {};
  p.global_outcomes = {};
}

}  // namespace owlint::flow
