#pragma once
// Fields that are not one key and one value: loads per axis, snapshots, thresholds with two meanings, lists by key.
// Each has a reading and a writing face, as in fields.hpp.

#include "suffuse/casefile/reader.hpp"
#include "suffuse/casefile/writer.hpp"

namespace suffuse::casefile {

/// "per-stage", "none", or { every = "1 %" }.
void snapshot_field(Reader& v, Snapshots& s);
void snapshot_field(Writer& v, const Snapshots& s);

/// Figure -> file with points, the paths taken from the case's folder.
void overlay_field(Reader& v, std::map<std::string, std::string>& overlay);
void overlay_field(Writer& v, const std::map<std::string, std::string>& overlay);

/// Path of the packing, taken from the case's folder, and where it was requested.
void packing_field(Reader& v, ImportSpec& s);
void packing_field(Writer& v, const ImportSpec& s);
void contacts_field(Reader& v, ImportSpec& s);
void contacts_field(Writer& v, const ImportSpec& s);

/// Three lengths, or the matrix whose columns are the cell vectors.
void cell_field(Reader& v, Mat3& h);
void cell_field(Writer& v, const Mat3& h);

/// `stress` per axis, "-" for a fixed one, or `pressure`; neither means constant volume.
void settle_stress_fields(Reader& v, cell::Loading& loading);
void settle_stress_fields(Writer& v, const cell::Loading& loading);

/// `velocity_gradient`: three rows of three rates, or nothing.
void gradient_field(Reader& v, std::optional<Mat3>& gradient);
void gradient_field(Writer& v, const std::optional<Mat3>& gradient);

/// `stress` and `strain_rate`, exactly one per axis, or `velocity_gradient`.
void loading_fields(Reader& v, cell::Loading& loading);
void loading_fields(Writer& v, const cell::Loading& loading);

/// Keys that belong to some paths only.
void check_path(Reader& v, const triaxial::TriaxialSpec& s);
void check_path(Writer& v, const triaxial::TriaxialSpec& s);

/// One amplitude.
void check_cycles(Reader& v, const triaxial::CyclicSpec& s);
void check_cycles(Writer& v, const triaxial::CyclicSpec& s);

/// An inertial servo needs its mass.
void check_servo(Reader& v, const cell::ServoSpec& s);
void check_servo(Writer& v, const cell::ServoSpec& s);

/// What only some laws have, such as what their shear stiffness follows from.
void spring_fields(Reader& v, grains::Material& m);
void spring_fields(Writer& v, const grains::Material& m);

/// A law may need keys whose defaults are another's, and may have no adhesion.
void check_law(Reader& v, const grains::Material& m);
void check_law(Writer& v, const grains::Material& m);

/// The start of a compaction is the protocol's: a user moves it for swift only.
void check_start(Reader& v, const packing::CompactSpec& s);
void check_start(Writer& v, const packing::CompactSpec& s);

/// One void ratio is requested at most.
void check_void_ratio(Reader& v, const packing::CompactSpec& s);
void check_void_ratio(Writer& v, const packing::CompactSpec& s);

/// A skeleton that is made first is compacted by itself, not pushed together with its fines.
void check_skeleton_first(Reader& v, const packing::CompactSpec& s);
void check_skeleton_first(Writer& v, const packing::CompactSpec& s);

/// Shear stresses are released by the secant servo, while other stresses are held.
void check_shear_stresses(Reader& v, const packing::CompactSpec& s);
void check_shear_stresses(Reader& v, const dem::SettleSpec& s);

template <class Spec>
void check_shear_stresses(Writer&, const Spec&) {}

/// A ratio, "strict" or "loose".
void inertial_number_field(Reader& v, double& value);
void inertial_number_field(Writer& v, double value);

/// `rule`, which only the velocity rule has.
void velocity_rule_field(Reader& v, erosion::DetachSpec& s);
void velocity_rule_field(Writer& v, const erosion::DetachSpec& s);

/// A share of free flight, a speed "1e-5 m/s", or a share of the diameter "0.1 d".
void over_field(Reader& v, erosion::DetachSpec& s);
void over_field(Writer& v, const erosion::DetachSpec& s);

/// { KEY = [values] }.
void sweep_field(Reader& v, std::string_view key, std::vector<Sweep>& sweeps);
void sweep_field(Writer& v, std::string_view key, const std::vector<Sweep>& sweeps);

/// `path` as the user wrote it, taken from the folder of the case; absolute.
std::string resolved_path(const std::string& folder, const std::string& path);

} // namespace suffuse::casefile
