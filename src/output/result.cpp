// SPDX-License-Identifier: Apache-2.0
#include "output/result.hpp"

#include "core/version.hpp"
#include "model/case.hpp"

namespace kerf {

const MetricList<RunPicture>& RunPicture::metrics() {
  static const MetricList<RunPicture> list{
      {"file", "1", "file", "File of the picture in the folder of the run.", &RunPicture::file},
      {"time", "s", "time", "Time of the picture.", &RunPicture::time}};
  return list;
}

const MetricList<RunOutcome>& RunOutcome::run_metrics() {
  using R = RunOutcome;
  static const MetricList<R> list{
      {"end_time", "s", "end of the run", "Simulated time at the end.", &R::time},
      {"steps", "1", "steps", "Number of time steps.", &R::steps},
      {"particles", "1", "particles at the end", "Number of particles at the end.", &R::particles},
      {"pair_interactions", "1", "pair interactions",
       "Number of pair interactions evaluated in the whole run.", &R::pair_interactions},
      {"wall_time", "s", "computing time", "Computing time over all parts of a resumed run.",
       &R::wall_time},
      {"title", "1", "title", "Title of the case.", [](const R& r) { return r.description.title; }},
      {"case", "1", "case", "Name of the case.", &R::case_name},
      {"dimension", "1", "dimensions", "Number of dimensions, 2 or 3.",
       [](const R& r) { return r.description.dimension; }},
      {"formulation", "1", "formulation", "Formulation of the equations.",
       [](const R& r) { return formulation_name(r.description.formulation); }},
      {"precision", "1", "precision", "`mixed` or `double`.",
       [](const R& r) {
         return r.description.precision == PrecisionKind::mixed ? "mixed" : "double";
       }},
      {"version", "1", "version", "Version of Kerf.", [](const R&) { return program_version; }},
      {"compiler", "1", "compiler", "Compiler that built Kerf.",
       [](const R&) { return compiler_name(); }},
      {"device", "1", "computed on", "Name of the processor or GPU.", &R::device},
      {"threads", "1", "threads", "Number of threads.", &R::threads}};
  return list;
}

const MetricList<RunOutcome>& RunOutcome::file_metrics() {
  static const MetricList<RunOutcome> list{
      {"frames", "1", "frames", "Number of frames that were written.", &RunOutcome::frames}};
  return list;
}

}  // namespace kerf
