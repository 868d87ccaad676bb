// The rooms one by one, by Google Benchmark: what each costs on a file given in the environment variable
// OWLINT_BENCH_INPUT. `./dev bench` times whole commands; this tells where the time goes.
#include <cstdlib>
#include <iostream>

#include <benchmark/benchmark.h>

#include "analyzer/flow/verdicts/analyze.h"
#include "analyzer/syntax/bulk.h"
#include "rules/driver/lint.h"

namespace {

using namespace owlint;

std::shared_ptr<const Source> input() {
  const char* path = std::getenv("OWLINT_BENCH_INPUT");
  std::string error;
  auto source = disk().read(path == nullptr ? "" : path, &error);
  if (source == nullptr) {
    std::cerr << "OWLINT_BENCH_INPUT: " << error << '\n';
    std::exit(2);
  }
  return source;
}

void report(benchmark::State& state, const Source& source) {
  state.SetBytesProcessed(static_cast<int64_t>(state.iterations() * source.bytes().size()));
}

void bulk(benchmark::State& state) {
  const auto source = input();
  for (auto _ : state) {
    PlainLines lines(source->bytes());
    Proven proven;
    proven.code = 1;
    proven.straight[0] = proven.arcs[0] = proven.alone[0] = UINT8_MAX;
    for (size_t at = 0; at < source->bytes().size();) {
      at = lines.pass(at, source->bytes().size(), proven).next;
      at = std::min(source->bytes().find('\n', at), source->bytes().size() - 1) + 1;
    }
  }
  report(state, *source);
}

void syntax(benchmark::State& state) {
  const auto source = input();
  for (auto _ : state) benchmark::DoNotOptimize(scan(*source));
  report(state, *source);
}

void program(benchmark::State& state) {
  const auto source = input();
  for (auto _ : state) benchmark::DoNotOptimize(build_program(source));
  report(state, *source);
}

void flow(benchmark::State& state) {
  const auto source = input();
  Library library(disk());
  const auto program = library.load(source);
  Linked linked(program, {}, library);
  for (auto _ : state) benchmark::DoNotOptimize(analyze_flow(linked, {}));
  report(state, *source);
}

void everything(benchmark::State& state) {
  const auto source = input();
  for (auto _ : state) benchmark::DoNotOptimize(lint(source, {}, {}));
  report(state, *source);
}

BENCHMARK(bulk)->Unit(benchmark::kMillisecond);
BENCHMARK(syntax)->Unit(benchmark::kMillisecond);
BENCHMARK(program)->Unit(benchmark::kMillisecond);
BENCHMARK(flow)->Unit(benchmark::kMillisecond);
BENCHMARK(everything)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
