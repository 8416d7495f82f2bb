#pragma once

// Exit codes: a promise to scripts.

namespace suffuse::apps {

enum ExitCode : int {
    Done = 0,
    Failed = 1,        ///< while running
    WrongUse = 2,      ///< of the command line
    BadCase = 3,       ///< the case or a data file has errors
    Flawed = 4,        ///< ran, but a quality bar was missed; the results are marked so
    Differs = 5,       ///< `compare` or `verify` found a difference
    OurDefect = 70,    ///< a broken promise of our own
    InputOutput = 74,  ///< cannot read or write, a folder without a run, or too little memory
    OutOfTime = 75,    ///< the time limit was reached; resumable
    BySignal = 128,    ///< and the signal's number: 129 SIGHUP, 130 SIGINT, 138 SIGUSR1, 140 SIGUSR2, 143 SIGTERM,
                       ///< 152 SIGXCPU; what is needed to go on was saved
    Interrupted = 130, ///< SIGINT
};

} // namespace suffuse::apps
