// Preloaded into the program: writes down every call that changes a file or a folder, in order, for power_loss.py,
// which replays them as a disk without power may have kept them.
//     RECORD_TO=FILE
// A record is a line, "KIND NUMBERS NAMES", for a write followed by its bytes. Files and folders go by
// device:inode.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static pthread_mutex_t in_turn = PTHREAD_MUTEX_INITIALIZER; // records stand in the order of the calls
static int record_file = -1;

__attribute__((constructor)) static void begin(void) {
    const char* path = getenv("RECORD_TO");
    if (path != NULL) {
        record_file = REAL(open)(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    }
}

__attribute__((format(printf, 3, 4))) static void record_line(const void* bytes, size_t size, const char* form, ...) {
    char line[2 * PATH_MAX];
    va_list rest;
    va_start(rest, form);
    const int length = vsnprintf(line, sizeof line - 1, form, rest);
    va_end(rest);
    line[length] = '\n';
    struct iovec parts[2] = {{line, (size_t)length + 1}, {(void*)bytes, size}};
    const int before = errno;
    if (record_file >= 0 && REAL(writev)(record_file, parts, 2) != (ssize_t)(length + 1 + (ssize_t)size)) {
        abort(); // half a record would be taken for what the program did
    }
    errno = before;
}

/// A name in its folder.
struct Entry {
    char folder[64], name[NAME_MAX + 1];
};

static void describe(const struct stat* there, char text[64]) {
    snprintf(text, 64, "%lu:%lu", (unsigned long)there->st_dev, (unsigned long)there->st_ino);
}

static struct Entry entry_at(int base, const char* path) {
    struct Entry entry = {"0:0", ""};
    char folder[PATH_MAX], name[PATH_MAX];
    snprintf(folder, sizeof folder, "%s", path);
    snprintf(name, sizeof name, "%s", path);
    struct stat there;
    if (fstatat(base, dirname(folder), &there, 0) == 0) {
        describe(&there, entry.folder);
    }
    snprintf(entry.name, sizeof entry.name, "%s", basename(name));
    return entry;
}

static int is_there(int base, const char* path, struct stat* there) {
    const int before = errno;
    const int found = fstatat(base, path, there, AT_SYMLINK_NOFOLLOW) == 0;
    errno = before;
    return found;
}

static void record_made(const char* kind, int base, const char* path) {
    struct stat there;
    if (is_there(base, path, &there)) {
        char self[64];
        describe(&there, self);
        const struct Entry entry = entry_at(base, path);
        record_line(NULL, 0, "%s %s %s %s", kind, entry.folder, self, entry.name);
    }
}

static void record_write(int descriptor, const void* bytes, ssize_t size, off_t at) {
    struct stat there;
    if (size > 0 && fstat(descriptor, &there) == 0 && S_ISREG(there.st_mode)) {
        char self[64];
        describe(&there, self);
        record_line(bytes, (size_t)size, "write %s %ld %zd", self, (long)at, size);
    }
}

static void record_call(const char* kind, int descriptor, long number) {
    struct stat there;
    if (fstat(descriptor, &there) == 0) {
        char self[64];
        describe(&there, self);
        record_line(NULL, 0, "%s %s %ld", kind, self, number);
    }
}

/// A signal waits meanwhile: its handler may write, too, and would wait for the turn of the call that it interrupts.
static void take_turn(sigset_t* before) {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, before);
    pthread_mutex_lock(&in_turn);
}

static void end_turn(const sigset_t* before) {
    pthread_mutex_unlock(&in_turn);
    const int error = errno; // of the call; a handler that has waited runs now
    pthread_sigmask(SIG_SETMASK, before, NULL);
    errno = error;
}

#define IN_TURN(type, call, record)                                                                                    \
    sigset_t before;                                                                                                   \
    take_turn(&before);                                                                                                \
    type result = call;                                                                                                \
    record;                                                                                                            \
    end_turn(&before);                                                                                                 \
    return result

ssize_t write(int descriptor, const void* bytes, size_t size) {
    IN_TURN(
        ssize_t, REAL(write)(descriptor, bytes, size),
        record_write(descriptor, bytes, result, lseek(descriptor, 0, SEEK_CUR) - result)
    );
}

ssize_t pwrite(int descriptor, const void* bytes, size_t size, off_t at) {
    IN_TURN(ssize_t, REAL(pwrite)(descriptor, bytes, size, at), record_write(descriptor, bytes, result, at));
}

ssize_t pwrite64(int descriptor, const void* bytes, size_t size, off64_t at) {
    IN_TURN(ssize_t, REAL(pwrite64)(descriptor, bytes, size, at), record_write(descriptor, bytes, result, at));
}

ssize_t writev(int descriptor, const struct iovec* parts, int count) { // the first of them: a short write is allowed
    return count > 0 ? write(descriptor, parts[0].iov_base, parts[0].iov_len) : 0;
}

/// No copy within the kernel: a caller that requests one takes this for a file system that has none, and reads and writes.
ssize_t sendfile(int to, int from, off_t* at, size_t size) {
    (void)to, (void)from, (void)at, (void)size;
    errno = EINVAL;
    return -1;
}

ssize_t sendfile64(int to, int from, off64_t* at, size_t size) {
    (void)to, (void)from, (void)at, (void)size;
    errno = EINVAL;
    return -1;
}

ssize_t copy_file_range(int from, off64_t* from_at, int to, off64_t* to_at, size_t size, unsigned flags) {
    (void)from, (void)from_at, (void)to, (void)to_at, (void)size, (void)flags;
    errno = EINVAL;
    return -1;
}

int ftruncate(int descriptor, off_t size) {
    IN_TURN(int, REAL(ftruncate)(descriptor, size), if (result == 0) record_call("cut", descriptor, (long)size));
}

int fsync(int descriptor) {
    IN_TURN(int, REAL(fsync)(descriptor), if (result == 0) record_call("sync", descriptor, 0));
}

int fdatasync(int descriptor) {
    IN_TURN(int, REAL(fdatasync)(descriptor), if (result == 0) record_call("sync", descriptor, 0));
}

int rename(const char* from, const char* to) {
    const struct Entry old = entry_at(AT_FDCWD, from), new = entry_at(AT_FDCWD, to);
    IN_TURN(
        int, REAL(rename)(from, to),
        if (result == 0) record_line(NULL, 0, "rename %s %s %s/%s", old.folder, new.folder, old.name, new.name)
    );
}

int mkdir(const char* path, mode_t mode) {
    IN_TURN(int, REAL(mkdir)(path, mode), if (result == 0) record_made("folder", AT_FDCWD, path));
}

int unlinkat(int folder, const char* path, int flags) {
    const struct Entry entry = entry_at(folder, path);
    IN_TURN(
        int, REAL(unlinkat)(folder, path, flags),
        if (result == 0) record_line(NULL, 0, "remove %s %s", entry.folder, entry.name)
    );
}

int unlink(const char* path) {
    return unlinkat(AT_FDCWD, path, 0);
}

int rmdir(const char* path) {
    return unlinkat(AT_FDCWD, path, AT_REMOVEDIR);
}

int remove(const char* path) {
    struct stat there;
    const int is_folder = is_there(AT_FDCWD, path, &there) && S_ISDIR(there.st_mode);
    return unlinkat(AT_FDCWD, path, is_folder ? AT_REMOVEDIR : 0);
}

static void record_opened(int was_there, const char* path, int descriptor, int flags) {
    if (descriptor >= 0 && !was_there && (flags & O_CREAT) != 0) {
        record_made("file", AT_FDCWD, path);
    } else if (descriptor >= 0 && was_there && (flags & O_TRUNC) != 0) {
        record_call("cut", descriptor, 0);
    }
}

#define OPEN(name)                                                                                                     \
    int name(const char* path, int flags, ...) {                                                                       \
        va_list rest;                                                                                                  \
        va_start(rest, flags);                                                                                         \
        const mode_t mode = (flags & (O_CREAT | __O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;                         \
        va_end(rest);                                                                                                  \
        struct stat there;                                                                                             \
        const int was_there = (flags & (O_CREAT | O_TRUNC)) != 0 && is_there(AT_FDCWD, path, &there);                  \
        IN_TURN(int, REAL(name)(path, flags, mode), record_opened(was_there, path, result, flags));                      \
    }
OPEN(open)
OPEN(open64)

#define FOPEN(name)                                                                                                    \
    FILE* name(const char* path, const char* mode) {                                                                   \
        struct stat there;                                                                                             \
        const int was_there = is_there(AT_FDCWD, path, &there);                                                        \
        const int flags = (mode[0] != 'r' ? O_CREAT : 0) | (mode[0] == 'w' ? O_TRUNC : 0);                             \
        IN_TURN(                                                                                                       \
            FILE*, REAL(name)(path, mode), record_opened(was_there, path, result != NULL ? fileno(result) : -1, flags)   \
        );                                                                                                             \
    }
FOPEN(fopen)
FOPEN(fopen64)
