#pragma once
// The table of verbs, in the order of the help. A new one is a file verb_NAME.cpp that defines make_NAME_verb(), and a
// row.

#include <memory>

namespace suffuse::apps {

class Verb;
using MadeVerb = std::unique_ptr<Verb>;

MadeVerb make_run_verb();
MadeVerb make_resume_verb();
MadeVerb make_report_verb();
MadeVerb make_figures_verb();
MadeVerb make_runs_verb();
MadeVerb make_compare_verb();
MadeVerb make_verify_verb();
MadeVerb make_watch_verb();
MadeVerb make_sweep_verb();
MadeVerb make_calibrate_verb();
MadeVerb make_cache_verb();
MadeVerb make_new_verb();
MadeVerb make_check_verb();
MadeVerb make_plan_verb();
MadeVerb make_explain_verb();
MadeVerb make_schema_verb();
MadeVerb make_bench_verb();
MadeVerb make_import_verb();
MadeVerb make_export_verb();
MadeVerb make_assess_verb();
MadeVerb make_completions_verb();
MadeVerb make_man_verb();
MadeVerb make_open_verb();
MadeVerb make_studio_verb();

inline constexpr MadeVerb (*verb_makers[])() = {
    make_run_verb,    make_resume_verb, make_report_verb,      make_figures_verb,   make_runs_verb,  make_compare_verb,
    make_verify_verb, make_watch_verb,  make_sweep_verb,       make_calibrate_verb, make_cache_verb, make_new_verb,
    make_check_verb,  make_plan_verb,   make_explain_verb,     make_schema_verb,    make_bench_verb, make_import_verb,
    make_export_verb, make_assess_verb, make_completions_verb, make_man_verb,       make_open_verb,  make_studio_verb,
};

} // namespace suffuse::apps
