// SPDX-License-Identifier: Apache-2.0
// Runs in Python: the run loop of `kerf run`, step by step, so that files and bits are the same.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/run_folder.hpp"
#include "core/error.hpp"
#include "library/run.hpp"
#include "output/balance_metrics.hpp"
#include "output/metric_json.hpp"
#include "python/bindings.hpp"

namespace py = pybind11;

namespace kerf::python {
namespace {

struct PythonOptions {
  std::filesystem::path folder;
  int threads = 0;
  std::string device;
  bool resume = false, force = false, ignore_memory = false, progress = false;
};

RunOptions options_of(const CaseText& text, const PythonOptions& options) {
  RunOptions run;
  run.folder = options.folder;
  if (options.threads < 0)
    throw UserError("threads = " + std::to_string(options.threads) +
                    ". Allowed: 0 (every core) and above.");
  run.threads = options.threads;
  if (options.device == word_of(Device::gpu))
    run.device = Device::gpu;
  else if (options.device != word_of(Device::cpu))
    throw UserError("device = \"" + options.device + "\". Allowed: \"cpu\", \"gpu\".");
  run.resume = options.resume;
  run.replace = options.force;
  run.ignores_memory = options.ignore_memory;
  run.shows_progress = options.progress;
  run.resume_words =
      "kerf.Run(case, \"" +
      (options.folder.empty() ? default_folder(text.file) : options.folder).string() +
      "\", resume=True)";
  run.ignore_memory_words = "kerf.Run(case, ignore_memory=True)";
  return run;
}

py::dtype dtype_of(FieldSpan::Number number) {
  switch (number) {
    case FieldSpan::Number::float32:
      return py::dtype::of<float>();
    case FieldSpan::Number::float64:
      return py::dtype::of<double>();
    case FieldSpan::Number::uint8:
      return py::dtype::of<std::uint8_t>();
    case FieldSpan::Number::uint16:
      return py::dtype::of<std::uint16_t>();
    default:
      return py::dtype::of<std::uint32_t>();
  }
}

// A run that other threads of Python leave alone while it works.
class LockedRun {
 public:
  LockedRun(const CaseText& text, const PythonOptions& options) {
    const RunOptions run = options_of(text, options);
    const py::gil_scoped_release release;
    run_.emplace(text.description, text.file, run);
    folder_ = run_->folder().string();
    if (run_->has_finished()) run_.reset();
  }

  void step(std::uint64_t count) {
    require_steps();
    const std::uint64_t last = run_->simulation().step() + count;
    advance([&] { return run_->simulation().step() >= last; });
  }
  void until(double time) {
    require_steps();
    advance([&] { return run_->simulation().time() >= time; });
  }
  void save() {
    require_steps();
    alone([&] { run_->save(); });
  }
  void finish() {
    if (!run_) return;
    advance([] { return false; });
    alone([&] { run_->finish(); });
    run_.reset();
  }
  // Lets go of the folder.
  void close() {
    if (run_) alone([] {});
    run_.reset();
  }

  bool is_over() const { return !run_ || run_->is_over(); }
  const Simulation& simulation() const {
    require_steps();
    return run_->simulation();
  }
  const std::string& folder() const { return folder_; }
  Frame frame() {
    require_steps();
    return run_->frame();
  }
  py::bytes picture(double scale) {
    require_steps();
    return run_->picture(scale);
  }
  py::object metrics() {
    require_steps();
    return to_python(nlohmann::ordered_json::parse(run_->result()));
  }
  py::object balance() const {
    const Balance now = simulation().balance();
    auto all = object_of(balance_terms(), now);
    all.update(object_of(balance_errors(), now));
    return to_python(all);
  }

  py::dict fields() const {
    py::dict shapes;
    for (const FieldSpan& span : simulation().fields())
      shapes[py::str(span.name)] = py::make_tuple(span.entries, span.components);
    return shapes;
  }
  // The array keeps a token; while one exists, the fields must stay where they are.
  py::array view(const std::string& name) const {
    for (const FieldSpan& span : simulation().fields()) {
      if (span.name != name) continue;
      const py::capsule token(new std::shared_ptr<int>(token_),
                              [](void* p) { delete static_cast<std::shared_ptr<int>*>(p); });
      return read_only_array(dtype_of(span.number), span.data, span.entries, span.components,
                             token);
    }
    throw py::key_error("no field \"" + name + "\"; see Run.fields");
  }

 private:
  void require_steps() const {
    if (!run_)
      throw UserError("the run in " + folder_ +
                      " has finished or is closed. Look at its results with kerf.Result, continue "
                      "it with resume=True, or run it again with force=True.");
  }

  // Works without Python's lock, so that other threads of Python go on.
  template <class Work>
  void alone(const Work& work) {
    if (is_busy_) throw UserError("another thread is advancing this run");
    if (token_.use_count() > 1) {
      PyErr_SetString(PyExc_BufferError,
                      "arrays of Run.view still exist, and a step moves what they show; delete "
                      "them, or keep a copy: run.view(name).copy()");
      throw py::error_already_set();
    }
    is_busy_ = true;
    try {
      const py::gil_scoped_release release;
      work();
    } catch (...) {
      is_busy_ = false;
      throw;
    }
    is_busy_ = false;
  }

  // Ctrl-C ends it between two steps.
  template <class Enough>
  void advance(const Enough& enough) {
    using Clock = std::chrono::steady_clock;
    bool interrupted = false;
    auto looked = Clock::now();
    alone([&] {
      run_->advance([&] {
        if (enough()) return true;
        if (Clock::now() - looked < std::chrono::milliseconds(50)) return false;
        looked = Clock::now();
        const py::gil_scoped_acquire acquire;
        interrupted = PyErr_CheckSignals() != 0;
        return interrupted;
      });
    });
    if (interrupted) throw py::error_already_set();
  }

  std::optional<Run> run_;  // empty once it has finished or is closed
  std::string folder_;
  bool is_busy_ = false;
  std::shared_ptr<int> token_ = std::make_shared<int>(0);
};

py::dict last_step(const LockedRun& self) {
  const StepInfo info = self.simulation().last_step();
  return py::dict(py::arg("dt") = info.dt, py::arg("limit") = info.limit,
                  py::arg("limiting_id") = info.limiting_id);
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<LockedRun>(module, "Run")
      .def(py::init([](const CaseText& text, const std::filesystem::path& folder, int threads,
                       const std::string& device, bool resume, bool force, bool ignore_memory,
                       bool progress) {
             return std::make_unique<LockedRun>(
                 text,
                 PythonOptions{folder, threads, device, resume, force, ignore_memory, progress});
           }),
           py::arg("case"), py::arg("out") = std::filesystem::path(), py::kw_only(),
           py::arg("threads") = 0, py::arg("device") = "cpu", py::arg("resume") = false,
           py::arg("force") = false, py::arg("ignore_memory") = false, py::arg("progress") = false)
      .def("_step", &LockedRun::step, py::arg("count"))
      .def("_until", &LockedRun::until, py::arg("time"))
      .def("_finish", &LockedRun::finish)
      .def("close", &LockedRun::close, "Let go of the folder, without a checkpoint.")
      .def("save", &LockedRun::save,
           "Write a checkpoint, from which `resume=True` continues bit for bit.")
      .def("frame", &LockedRun::frame, "Return a copy of the particles as they are now.")
      .def("picture", &LockedRun::picture, py::arg("scale") = 1.0,
           "Return a picture of the particles, the bytes of a PNG file.")
      .def("metrics", &LockedRun::metrics,
           "Return what result.json would hold if the run ended now.")
      .def("balance", &LockedRun::balance,
           "Return the balance of mass, momentum and energy, SI units.")
      .def("view", &LockedRun::view, py::arg("name"),
           "Return a field of the particles as a read-only NumPy array without a copy.\n\n"
           "The order of the particles changes from step to step; `id` identifies them. As long as "
           "such an array exists, a step raises BufferError.")
      .def_property_readonly("fields", &LockedRun::fields,
                             "Particles and components of each field that `view` shows, by name.")
      .def_property_readonly("is_over", &LockedRun::is_over, "Whether the run has reached its end.")
      .def_property_readonly("folder", &LockedRun::folder, "The folder of the results.")
      .def_property_readonly(
          "time", [](const LockedRun& self) { return self.simulation().time(); }, "Time, s.")
      .def_property_readonly(
          "steps", [](const LockedRun& self) { return self.simulation().step(); }, "Steps taken.")
      .def_property_readonly(
          "particles", [](const LockedRun& self) { return self.simulation().particles(); },
          "Particles present.")
      .def_property_readonly("last_step", &last_step,
                             "The last time step, dt (s), and the limit that set it.")
      .def_property_readonly(
          "probe_values", [](const LockedRun& self) { return self.simulation().probe_values(); },
          "Values of the probes: point: pressure (Pa) and velocity (m/s); plane: force (N).");
}

}  // namespace kerf::python
