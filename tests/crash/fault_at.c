// Preloaded into the program: counts the calls that change files, and at the N-th of them kills the program, cuts a write
// in half and then kills it, or lets the call fail. Calls on pipes and terminals are not counted.
//     FAULT_AT=N  FAULT_DO=before|after|half|EIO|ENOSPC|EINTR      FAULT_COUNT=FILE: how many there were
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

static atomic_long calls;

enum Fault { NONE, BEFORE, AFTER, HALF, FAIL };

_Noreturn static void die(void) {
    kill(getpid(), SIGKILL);
    for (;;) {
        pause();
    }
}

static int requested_error(const char* what) {
    return strcmp(what, "EIO") == 0 ? EIO : strcmp(what, "ENOSPC") == 0 ? ENOSPC : strcmp(what, "EINTR") == 0 ? EINTR : 0;
}

/// What is to happen to this call; errno is set where it is to fail.
static enum Fault next(void) {
    const char *at = getenv("FAULT_AT"), *what = getenv("FAULT_DO");
    const long number = atomic_fetch_add(&calls, 1) + 1;
    if (at == NULL || what == NULL || number != atol(at)) {
        return NONE;
    }
    if (requested_error(what) != 0) {
        errno = requested_error(what);
        return FAIL;
    }
    return strcmp(what, "before") == 0 ? BEFORE : strcmp(what, "after") == 0 ? AFTER : HALF;
}

static int is_file(int descriptor) {
    struct stat there;
    return fstat(descriptor, &there) == 0 && S_ISREG(there.st_mode);
}

__attribute__((destructor)) static void report(void) {
    const char* path = getenv("FAULT_COUNT");
    FILE* file = path != NULL ? fopen(path, "w") : NULL;
    if (file != NULL) {
        fprintf(file, "%ld\n", (long)calls);
        fclose(file);
    }
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))
#define GUARD(call, failed)                                                                                            \
    switch (next()) {                                                                                                  \
    case BEFORE:                                                                                                       \
    case HALF:                                                                                                         \
        die();                                                                                                         \
    case AFTER:                                                                                                        \
        call;                                                                                                          \
        die();                                                                                                         \
    case FAIL:                                                                                                         \
        return failed;                                                                                                 \
    default:                                                                                                           \
        return call;                                                                                                   \
    }
#define GUARD_WRITE(call, half_call)                                                                                   \
    switch (next()) {                                                                                                  \
    case BEFORE:                                                                                                       \
        die();                                                                                                         \
    case HALF:                                                                                                         \
        half_call;                                                                                                     \
        die();                                                                                                         \
    case AFTER:                                                                                                        \
        call;                                                                                                          \
        die();                                                                                                         \
    case FAIL:                                                                                                         \
        return -1;                                                                                                     \
    default:                                                                                                           \
        return call;                                                                                                   \
    }

ssize_t write(int descriptor, const void* bytes, size_t size) {
    if (!is_file(descriptor)) {
        return REAL(write)(descriptor, bytes, size);
    }
    GUARD_WRITE(REAL(write)(descriptor, bytes, size), REAL(write)(descriptor, bytes, size / 2))
}

ssize_t writev(int descriptor, const struct iovec* parts, int count) {
    if (!is_file(descriptor)) {
        return REAL(writev)(descriptor, parts, count);
    }
    GUARD_WRITE(REAL(writev)(descriptor, parts, count), REAL(write)(descriptor, parts[0].iov_base, parts[0].iov_len / 2))
}

ssize_t pwrite(int descriptor, const void* bytes, size_t size, off_t offset) {
    GUARD_WRITE(REAL(pwrite)(descriptor, bytes, size, offset), REAL(pwrite)(descriptor, bytes, size / 2, offset))
}

ssize_t pwrite64(int descriptor, const void* bytes, size_t size, off64_t offset) {
    GUARD_WRITE(REAL(pwrite64)(descriptor, bytes, size, offset), REAL(pwrite64)(descriptor, bytes, size / 2, offset))
}

int fsync(int descriptor) {
    GUARD(REAL(fsync)(descriptor), -1)
}

int ftruncate(int descriptor, off_t size) {
    GUARD(REAL(ftruncate)(descriptor, size), -1)
}

int rename(const char* from, const char* to) {
    GUARD(REAL(rename)(from, to), -1)
}

int mkdir(const char* path, mode_t mode) {
    GUARD(REAL(mkdir)(path, mode), -1)
}

int unlink(const char* path) {
    GUARD(REAL(unlink)(path), -1)
}

int unlinkat(int folder, const char* path, int flags) {
    GUARD(REAL(unlinkat)(folder, path, flags), -1)
}

#define OPEN(name)                                                                                                     \
    int name(const char* path, int flags, ...) {                                                                       \
        mode_t mode = 0;                                                                                               \
        if ((flags & O_CREAT) != 0) {                                                                                  \
            va_list rest;                                                                                              \
            va_start(rest, flags);                                                                                     \
            mode = va_arg(rest, mode_t);                                                                               \
            va_end(rest);                                                                                              \
            GUARD(REAL(name)(path, flags, mode), -1)                                                                   \
        }                                                                                                              \
        return REAL(name)(path, flags, mode);                                                                          \
    }
OPEN(open)
OPEN(open64)
