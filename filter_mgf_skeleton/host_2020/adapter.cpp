// SPDX-License-Identifier: GPL-3.0-or-later
#include "adapter.h"

#include <QFileInfo>

#include "filter_mgf_skeleton/layer_writer.h"
#include "filter_mgf_skeleton/parameter_bridge.h"
#include "vcg_ext/input/bridge.h"

using namespace mgf::plugin;

namespace {

QString qt(const std::string& text) {
  return QString::fromStdString(text);
}

double diagonal_of(const MeshModel* model) {
  // Without a mesh the filter will refuse; its dialog shows lengths for a unit diagonal until then.
  return model == nullptr || model->cm.bbox.IsNull() ? 1.0 : model->cm.bbox.Diag();
}

/// The layer's label without the suffix of the file that it came from.
QString base_name(const MeshModel& model) {
  const bool is_file = !model.shortName().isEmpty() && model.label() == model.shortName();
  return is_file ? QFileInfo(model.label()).completeBaseName() : model.label();
}

/// What a former run has made from `input` under the name of `layer`.
MeshModel* former_layer(MeshDocument& document, const Layer& layer, const MeshModel& input) {
  for (MeshModel* model : document.meshList) {
    const std::optional<LayerOrigin> origin = origin_of(*model);
    if (origin && origin->source == input.id() && origin->name == layer.name) return model;
  }
  return nullptr;
}

/// The layer to work on: the current one; or, for a filter that replaces its layers while the user
/// looks at them, the one that the current layer was made from.
MeshModel* input_layer(const Filter& filter, MeshDocument& document) {
  MeshModel* current = document.mm();
  if (current == nullptr || filter.effect != FilterEffect::kReplacesLayers) return current;
  const std::optional<LayerOrigin> origin = origin_of(*current);
  MeshModel* model = origin ? document.getMesh(origin->source) : nullptr;
  return model != nullptr ? model : current;
}

void write_output(const FilterOutput& output, const QString& name, MeshModel& input,
                  MeshDocument& document) {
  for (const Layer& layer : output.layers) {
    const QString label = name + " " + qt(layer.name);
    MeshModel* former = layer.replaces_former ? former_layer(document, layer, input) : nullptr;
    // What the user has hidden stays hidden.
    const bool visible = former != nullptr ? former->visible : !layer.hidden;
    if (former != nullptr) clear_layer(*former);
    MeshModel* model = former != nullptr ? former : document.addNewMesh(QString(), label, false);
    write_layer(layer, input, *model);
    model->visible = visible;
  }
  if (output.paint) write_paint(*output.paint, input);
  if (output.selection) write_selection(*output.selection, input);
}

/// Holds a flag for as long as a filter runs.
class Running {
 public:
  explicit Running(bool& flag) : flag_(flag) { flag_ = true; }
  ~Running() { flag_ = false; }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

 private:
  bool& flag_;
};

}  // namespace

MgfSkeletonPlugin::MgfSkeletonPlugin() {
  for (std::size_t id = 0; id < all_filters().size(); ++id) {
    typeList << static_cast<FilterIDType>(id);
    actionList << new QAction(qt(all_filters()[id].name), this);
  }
}

QString MgfSkeletonPlugin::pluginName() const {
  return "FilterMgfSkeleton";
}

QString MgfSkeletonPlugin::filterName(FilterIDType id) const {
  return qt(all_filters()[static_cast<std::size_t>(id)].name);
}

QString MgfSkeletonPlugin::filterInfo(FilterIDType id) const {
  return qt(all_filters()[static_cast<std::size_t>(id)].help);
}

const Filter& MgfSkeletonPlugin::filter(QAction* action) const {
  return all_filters()[static_cast<std::size_t>(ID(action))];
}

MeshFilterInterface::FilterClass MgfSkeletonPlugin::getClass(QAction* action) {
  switch (filter(action).effect) {
    case FilterEffect::kAddsLayers:
    case FilterEffect::kReplacesLayers:
      return FilterClass(Remeshing | Measure);
    case FilterEffect::kPaintsInput:
    case FilterEffect::kPaintsAndAddsLayers:
      return FilterClass(Quality | FaceColoring);
    case FilterEffect::kSelects:
      return FilterClass(Measure | Selection);
    case FilterEffect::kWritesFiles:
      return Measure;
  }
  return Generic;
}

int MgfSkeletonPlugin::getPreConditions(QAction*) const {
  return MeshModel::MM_NONE;
}

// Only what changes on the input: MeshLab notices new layers by itself. That a former layer has
// been replaced it notices by the faces' corners, which no preview reverts.
int MgfSkeletonPlugin::postCondition(QAction* action) const {
  switch (filter(action).effect) {
    case FilterEffect::kPaintsInput:
    case FilterEffect::kPaintsAndAddsLayers:
      return MeshModel::MM_FACEQUALITY | MeshModel::MM_FACECOLOR | MeshModel::MM_VERTQUALITY;
    case FilterEffect::kSelects:
      return MeshModel::MM_VERTFLAGSELECT | MeshModel::MM_FACEFLAGSELECT;
    case FilterEffect::kReplacesLayers:
      return MeshModel::MM_FACEVERT;
    default:
      return MeshModel::MM_NONE;
  }
}

// MeshLab offers a preview for filters of a single mesh. Only the quick ones want it; undoing that
// of the others would revert their paint.
MeshFilterInterface::FILTER_ARITY MgfSkeletonPlugin::filterArity(QAction* action) const {
  return filter(action).effect == FilterEffect::kReplacesLayers ? SINGLE_MESH : FIXED;
}

void MgfSkeletonPlugin::initParameterSet(QAction* action, MeshDocument& document,
                                         RichParameterList& list) {
  declare_parameters(filter(action).parameters, diagonal_of(document.mm()), list);
}

bool MgfSkeletonPlugin::applyFilter(QAction* action, MeshDocument& document,
                                    const RichParameterList& list, vcg::CallBackPos* callback) {
  // Nothing may be thrown into MeshLab: it would end the program.
  try {
    if (running_) {
      return fail({"already_running", "A filter of this plugin is running. Wait for its end."});
    }
    const Running running(running_);
    return apply(filter(action), document, list, callback);
  } catch (const mgf::InputError& error) {
    return fail({error.code(), error.what()});
  } catch (const std::exception& error) {
    return fail({"host_error", error.what()});
  } catch (...) {
    return fail({"host_error", "MeshLab reported an error of an unknown kind."});
  }
}

bool MgfSkeletonPlugin::apply(const Filter& filter, MeshDocument& document,
                              const RichParameterList& list, vcg::CallBackPos* callback) {
  MeshModel* current = input_layer(filter, document);
  if (current == nullptr) return fail({"no_mesh", "There is no mesh: open one first."});
  const int id = current->id();
  const mgf::TriangleSurface mesh = mgf::bridge_from_mesh(current->cm).surface;
  const QString name = base_name(*current);
  const ParameterValues values = read_parameters(filter.parameters, list);
  const mgf::Progress progress([callback](double share, const char* stage) {
    return callback == nullptr || callback(static_cast<int>(100.0 * share), stage);
  });

  const FilterOutcome outcome =
      run_filter(filter, {mesh, name.toStdString(), values, *workbench_, progress});

  // The callback let events through: the user may have closed or edited the layer meanwhile.
  MeshModel* input = document.getMesh(id);
  if (input == nullptr || static_cast<std::size_t>(input->cm.vn) != mesh.points.size() ||
      static_cast<std::size_t>(input->cm.fn) != mesh.triangles.size()) {
    return fail({"layer_changed", "The layer was closed or changed while the filter ran."});
  }
  write_output(outcome.output, name, *input, document);
  log(outcome.output);
  return outcome.failure ? fail(*outcome.failure) : true;
}

bool MgfSkeletonPlugin::fail(const Failure& failure) {
  // meshlabserver never prints errorMessage, the window shows it as HTML: so both.
  errorMessage = qt(failure.message).toHtmlEscaped();
  Log(GLLogStream::WARNING, "Error (" + failure.code + "): " + failure.message);
  return false;
}

void MgfSkeletonPlugin::log(const FilterOutput& output) {
  for (const std::string& note : output.notes) Log(GLLogStream::FILTER, note);
  for (const Measurement& measure : output.measures) {
    Log(GLLogStream::FILTER,
        measure.text + ": " + QString::number(measure.value, 'g', 9).toStdString());
  }
  for (const mgf::Warning& warning : output.warnings) {
    Log(GLLogStream::WARNING, "Warning (" + warning.code + "): " + warning.message);
  }
}
