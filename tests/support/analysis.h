// The parts of a flow analysis around a program that a unit test gives as text.
#pragma once

#include <memory>
#include <memory_resource>
#include <string>

#include "analyzer/flow/engine/iteration.h"
#include "analyzer/text/memory_files.h"

namespace owlint::test {

/// A program on no machine, ready to be analysed.
struct LinkedText {
  explicit LinkedText(const std::string& text)
      : program(library.load(Source::own("unit.ngc", text))), linked(program, profile, library) {}

  Profile profile;
  MemoryFiles files;  // none: the program calls no file
  Library library{files};
  std::shared_ptr<const Program> program;
  Linked linked;
};

/// The parts of the engine that a part under test needs.
struct Engine {
  explicit Engine(const std::string& text, flow::Limits given = {})
      : limits(given), source(text), machine(source.linked, source.profile, limits, pool) {}

  flow::Limits limits;
  LinkedText source;
  flow::PersistentMap::Pool pool;
  flow::AbstractMachine machine;
  flow::Precision precision{limits, false};
  std::pmr::monotonic_buffer_resource memory;
  flow::Separation separation{*source.program, machine, precision, limits};
  flow::Worklist worklist;
  flow::Trace trace{limits, source.program->size()};
  flow::Partitions partitions{*source.program, machine, separation, precision, memory};
  flow::Calls calls{machine, limits, precision, separation, worklist, trace, nullptr, memory};
};

/// At most so many states at a line and calls of a sub; nothing else is changed.
inline flow::Limits at_most(size_t states, size_t contexts) {
  flow::Limits limits;
  for (auto& level : limits.levels) {
    level.states = std::min(level.states, states);
    level.contexts = std::min(level.contexts, contexts);
  }
  return limits;
}

}  // namespace owlint::test
