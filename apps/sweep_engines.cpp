#include "apps/sweep_engines.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::apps {
namespace {

// A minute before the end, Slurm sends SIGUSR1 to the script. SIGTERM means that the job was cancelled or preempted.
constexpr std::string_view slurm_directives = R"(#SBATCH --job-name=@job@
#SBATCH --array=@array@
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=@threads@
#SBATCH --mem=@memory@M
#SBATCH --time=@minutes@
#SBATCH --partition=@partition@
#SBATCH --account=@account@
#SBATCH --output=@log@
#SBATCH --open-mode=append
#SBATCH --requeue
#SBATCH --signal=B:USR1@@60
)";

// A task that never comes further than its start would be put back for ever.
constexpr std::string_view slurm_go_on = R"(75 | 138)
    if [ "${SLURM_RESTART_COUNT:-0}" -lt 1000 ] && scontrol requeue "$SLURM_JOB_ID"; then
        echo "suffuse: to be continued; the task was put back into the queue" >&2
        exit 0
    fi
    echo "suffuse: to be continued, but the task could not be put back into the queue; when the others have ended, write the rest anew: @again@" >&2
    ;;
)";

constexpr std::string_view pbs_directives = R"(#PBS -N @plain_job@
#PBS -J @range@
#PBS -l select=1:ncpus=@threads@:mem=@memory@mb
#PBS -l walltime=@clock@
#PBS -q @partition@
#PBS -A @account@
#PBS -j oe
#PBS -o @log@
#PBS -r y
)";

constexpr std::string_view pbs_go_on = R"(75 | 138 | 143)
    echo "suffuse: to be continued; when the others have ended, write the rest anew: @again@" >&2
    ;;
)";

constexpr std::string_view sge_directives = R"(#$ -S /bin/sh
#$ -N @plain_job@
#$ -t @array@
#$ -pe smp @several_threads@
#$ -l h_vmem=@memory_of_thread@M
#$ -l h_rt=@clock@
#$ -q @partition@
#$ -P @account@
#$ -j y
#$ -o @log@
#$ -r y
#$ -notify
)";

// Grid Engine puts back what ends with 99. With -notify, SIGUSR2 comes before the end.
constexpr std::string_view sge_go_on = R"(75 | 138 | 140)
    echo "suffuse: to be continued" >&2
    exit 99
    ;;
)";

constexpr std::string_view lsf_directives = R"(#BSUB -J "@plain_job@[@array@]"
#BSUB -J @single_job@
#BSUB -n @threads@
#BSUB -R "span[hosts=1] rusage[mem=@memory@MB]"
#BSUB -W @minutes@
#BSUB -q @partition@
#BSUB -P @account@
#BSUB -o @log@
#BSUB -r
#BSUB -wa USR1 -wt 1
#BSUB -Q "75 138 140"
)";

constexpr std::string_view lsf_go_on = R"(75 | 138 | 140)
    echo "suffuse: to be continued" >&2
    ;;
)";

constexpr std::string_view snakemake = R"(# @what@. Run:  @command@
# Finished tasks are not repeated. A task that was stopped continues when Snakemake is called again.
workdir: @folder@

with open(@tasks@) as lines:
    tasks = lines.read().splitlines()


rule gather:
    input: expand("tasks/{number}.done", number=range(1, len(tasks) + 1))
    params: gather=lambda wildcards: @collect@
    shell: "( {params.gather} ) >>tasks/gather.txt 2>&1 || [ $? -eq 4 ]"


rule task:
    output: touch("tasks/{number}.done")
    log: "tasks/{number}.txt"
    threads: @threads@
    resources:
        mem_mb=@memory@,
        runtime=@minutes@,
        slurm_partition="@partition@",
        slurm_account="@account@",
    params: task=lambda wildcards: tasks[int(wildcards.number) - 1]
    shell: "( {params.task} ) >>{log} 2>&1 || [ $? -eq 4 ]"
)";

std::vector<Engine> make_engines() {
    return {
        {.name = "slurm",
         .title = "Slurm",
         .file = "sweep.sbatch",
         .tried = "22.05",
         .most_tasks = 1000,
         .limit =
             "scontrol show config | awk '/^MaxArraySize / { print ($3 > 0 ? $3 - 1 : 0) }'", // the index ends before
         .log = "%a.txt",
         .directives = slurm_directives,
         .index = "SLURM_ARRAY_TASK_ID",
         .go_on = slurm_go_on,
         .submit = R"(sbatch --parsable "$script" | sed 's/;.*//')",
         .job = "$job",
         .joint = ":",
         .gather = R"(sbatch --dependency="afterany:$jobs" "$script")"},
        {.name = "pbs",
         .title = "PBS",
         .file = "sweep.pbs",
         .most_tasks = 10'000,
         .log = "^array_index^.txt",
         .directives = pbs_directives,
         .index = "PBS_ARRAY_INDEX",
         .go_on = pbs_go_on,
         .submit = R"(qsub "$script")",
         .job = "$job",
         .joint = ":",
         .gather = R"(qsub -W depend="afterany:$jobs" "$script")"},
        {.name = "sge",
         .title = "Grid Engine",
         .file = "sweep.sge",
         .most_tasks = 75'000,
         .log = "$TASK_ID.txt",
         .directives = sge_directives,
         .index = "SGE_TASK_ID",
         .go_on = sge_go_on,
         .submit = R"(qsub -terse "$script" | sed 's/\..*//')",
         .job = "$job",
         .joint = ",",
         .gather = R"(qsub -hold_jid "$jobs" "$script")"},
        {.name = "lsf",
         .title = "LSF",
         .file = "sweep.lsf",
         .most_tasks = 1000,
         .log = "%I.txt",
         .directives = lsf_directives,
         .index = "LSB_JOBINDEX",
         .go_on = lsf_go_on,
         .submit = R"(bsub <"$script" | sed -n 's/^Job <\([0-9]*\)>.*/\1/p')",
         .job = "ended($job)",
         .joint = " && ",
         .gather = R"(bsub -w "$jobs" <"$script")"},
        {.name = "snakemake",
         .title = "Snakemake",
         .file = "sweep.smk",
         .tried = "7.21",
         .whole = snakemake,
         .command = "snakemake --snakefile @script@ --cores all --keep-going"},
        {.name = "parallel",
         .title = "GNU parallel",
         .file = "tasks.txt",
         .tried = "20221122",
         .command = "parallel < @script@     (or one after the other: sh @script@)"},
    };
}

} // namespace

const std::vector<Engine>& engines() {
    static const std::vector<Engine> table = make_engines();
    return table;
}

const Engine* find_engine(std::string_view name) {
    const auto found = std::ranges::find(engines(), name, &Engine::name);
    return found == engines().end() ? nullptr : &*found;
}

std::vector<std::string> engine_names() {
    std::vector<std::string> names;
    names.reserve(engines().size());
    for (const Engine& engine : engines()) {
        names.emplace_back(engine.name);
    }
    return names;
}

std::string fill_template(std::string_view text, const std::map<std::string, std::string>& values) {
    std::string filled;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        std::string_view rest = text.substr(0, end);
        text.remove_prefix(end);
        std::string line;
        bool is_wanted = true;
        for (std::size_t mark = rest.find('@'); mark != std::string_view::npos; mark = rest.find('@')) {
            const std::size_t close = rest.find('@', mark + 1);
            line += rest.substr(0, mark);
            expects(close != std::string_view::npos, "a key of a template stands between two @");
            const std::string key(rest.substr(mark + 1, close - mark - 1));
            rest.remove_prefix(close + 1);
            if (key.empty()) { // @@ stands for one
                line += '@';
                continue;
            }
            const auto value = values.find(key);
            if (value == values.end()) {
                throw Bug(fmt::format("a template of an engine names {}, which has no value", key));
            }
            is_wanted = is_wanted && !value->second.empty();
            line += value->second;
        }
        if (is_wanted) {
            filled += line;
            filled += rest;
        }
    }
    return filled;
}

} // namespace suffuse::apps
