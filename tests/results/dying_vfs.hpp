// SQLite's file system, in which a process dies, or the disk is full, at a chosen operation.
#pragma once

#include <sqlite3.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <utility>

namespace fixtures {

/// Stands before the default file system as long as it lives, for connections opened meanwhile. Every write,
/// truncation, sync and removal is counted from 1; before each, `at` is asked what to do.
class DyingVfs {
  public:
    enum class Deed : unsigned char { go_on, die, disk_full };
    using At = std::function<Deed(int operation, const std::string& what)>;

    explicit DyingVfs(At at) : at_(std::move(at)), real_(sqlite3_vfs_find(nullptr)), vfs_(*real_) {
        vfs_.zName = "dying";
        vfs_.pAppData = this;
        vfs_.szOsFile = real_->szOsFile + static_cast<int>(sizeof(File));
        vfs_.xOpen = open;
        vfs_.xDelete = remove;
        sqlite3_vfs_register(&vfs_, 1);
    }
    ~DyingVfs() {
        sqlite3_vfs_unregister(&vfs_);
        sqlite3_vfs_register(real_, 1);
    }
    DyingVfs(const DyingVfs&) = delete;
    DyingVfs& operator=(const DyingVfs&) = delete;

    [[nodiscard]] int operations() const { return operations_; }

  private:
    /// SQLite's file begins with its methods; the real file stands behind it.
    struct File {
        const sqlite3_io_methods* methods;
        DyingVfs* vfs;
        sqlite3_io_methods own;
        [[nodiscard]] sqlite3_file* real() { return reinterpret_cast<sqlite3_file*>(this + 1); }
    };
    static File* of(sqlite3_file* file) { return reinterpret_cast<File*>(file); }
    static sqlite3_file* real(sqlite3_file* file) { return of(file)->real(); }

    int ask(const std::string& what) {
        switch (at_(++operations_, what)) {
            case Deed::die:
                ::_exit(0);
            case Deed::disk_full:
                return SQLITE_FULL;
            case Deed::go_on:
                break;
        }
        return SQLITE_OK;
    }

    static int open(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* out_flags) {
        auto* self = static_cast<DyingVfs*>(vfs->pAppData);
        File* own = of(file);
        own->methods = nullptr;
        own->vfs = self;
        const int rc = self->real_->xOpen(self->real_, name, own->real(), flags, out_flags);
        if (own->real()->pMethods == nullptr) return rc;
        own->own = forwarding(own->real()->pMethods->iVersion);
        own->methods = &own->own;
        return rc;
    }
    static int remove(sqlite3_vfs* vfs, const char* name, int sync) {
        auto* self = static_cast<DyingVfs*>(vfs->pAppData);
        if (const int rc = self->ask(std::string("remove ") + name); rc != SQLITE_OK) return rc;
        return self->real_->xDelete(self->real_, name, sync);
    }

    static sqlite3_io_methods forwarding(int version) {
        sqlite3_io_methods m{};
        m.iVersion = version < 2 ? version : 2;
        m.xClose = [](sqlite3_file* f) { return real(f)->pMethods->xClose(real(f)); };
        m.xRead = [](sqlite3_file* f, void* to, int bytes, sqlite3_int64 at) {
            return real(f)->pMethods->xRead(real(f), to, bytes, at);
        };
        m.xWrite = [](sqlite3_file* f, const void* from, int bytes, sqlite3_int64 at) {
            if (const int rc = of(f)->vfs->ask("write"); rc != SQLITE_OK) return rc;
            return real(f)->pMethods->xWrite(real(f), from, bytes, at);
        };
        m.xTruncate = [](sqlite3_file* f, sqlite3_int64 size) {
            if (const int rc = of(f)->vfs->ask("truncate"); rc != SQLITE_OK) return rc;
            return real(f)->pMethods->xTruncate(real(f), size);
        };
        m.xSync = [](sqlite3_file* f, int) { return of(f)->vfs->ask("sync"); };  // no power is cut here
        m.xFileSize = [](sqlite3_file* f, sqlite3_int64* size) {
            return real(f)->pMethods->xFileSize(real(f), size);
        };
        m.xLock = [](sqlite3_file* f, int lock) { return real(f)->pMethods->xLock(real(f), lock); };
        m.xUnlock = [](sqlite3_file* f, int lock) { return real(f)->pMethods->xUnlock(real(f), lock); };
        m.xCheckReservedLock = [](sqlite3_file* f, int* out) {
            return real(f)->pMethods->xCheckReservedLock(real(f), out);
        };
        m.xFileControl = [](sqlite3_file* f, int op, void* arg) {
            return real(f)->pMethods->xFileControl(real(f), op, arg);
        };
        m.xSectorSize = [](sqlite3_file* f) { return real(f)->pMethods->xSectorSize(real(f)); };
        m.xDeviceCharacteristics = [](sqlite3_file* f) {
            return real(f)->pMethods->xDeviceCharacteristics(real(f));
        };
        m.xShmMap = [](sqlite3_file* f, int page, int size, int extend, void volatile** out) {
            return real(f)->pMethods->xShmMap(real(f), page, size, extend, out);
        };
        m.xShmLock = [](sqlite3_file* f, int offset, int n, int flags) {
            return real(f)->pMethods->xShmLock(real(f), offset, n, flags);
        };
        m.xShmBarrier = [](sqlite3_file* f) { real(f)->pMethods->xShmBarrier(real(f)); };
        m.xShmUnmap = [](sqlite3_file* f, int remove_it) {
            return real(f)->pMethods->xShmUnmap(real(f), remove_it);
        };
        return m;
    }

    At at_;
    sqlite3_vfs* real_;
    sqlite3_vfs vfs_;
    int operations_ = 0;
};

}  // namespace fixtures
