// Bodies of folder_files.hpp: the files of a mesh that is a folder, which replace those of the same names together.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/detail/files/folder_files.hpp>
#include <concino/io/detail/files/io_errors.hpp>
#include <concino/io/detail/files/paths.hpp>
#include <concino/io/detail/files/system_files.hpp>

#include <cerrno>
#include <utility>

namespace concino::detail {

/// The path of a second name for a file while it is replaced.
inline std::string backup_of(const std::string& path) {
  const std::size_t slash = path.rfind('/') + 1;
  return core::joined({std::string_view(path).substr(0, slash),
                       atomic_file::temporary_name(std::string_view(path).substr(slash)), ".old"});
}

CONCINO_INLINE folder_files::folder_files(const std::string& path, bool sync) : sync_(sync) {
  check_path(path);
  folder_ = with_slashes(path);
  while (folder_.size() > 1 && folder_.back() == '/') folder_.pop_back();
  if (const file_kind kind = status_of(folder_).kind; kind != file_kind::none && kind != file_kind::folder)
    throw_io_error(path, "cannot be written", ENOTDIR);
  std::vector<std::string> missing;
  for (std::string at = folder_; !at.empty() && status_of(at).kind == file_kind::none;) {
    missing.push_back(at);
    const std::size_t slash = at.rfind('/');
    at.resize(slash == std::string::npos ? 0 : slash);
  }
  created_.reserve(missing.size());  // nothing below allocates once there is a new folder
  folder_.reserve(folder_.size() + 1);
  while (!missing.empty()) {
    if (!create_folder(missing.back())) {
      const int why = errno;
      for (const std::string& created : created_) remove_folder(created);
      throw_io_error(path, "cannot be created", why);
    }
    created_.insert(created_.begin(), std::move(missing.back()));
    missing.pop_back();
  }
  folder_ += '/';
}

CONCINO_INLINE folder_files::~folder_files() {
  parts_.clear();
  if (!is_committed_)
    for (const std::string& created : created_) remove_folder(created);
}

CONCINO_INLINE text_sink& folder_files::file(std::string_view name) {
  parts_.push_back(std::make_unique<part>(core::joined({folder_, name}), sync_));
  return parts_.back()->out;
}

CONCINO_INLINE bool folder_files::remove(std::string_view name) {
  std::string path = core::joined({folder_, name});
  stale_.push_back(backup_of(path));
  if (status_of_link(path).kind != file_kind::regular) return false;
  removed_backups_.push_back(stale_.back());
  removed_.push_back(std::move(path));
  return true;
}

CONCINO_INLINE void folder_files::finish() {
  for (const std::unique_ptr<part>& p : parts_) {
    p->out.flush();
    p->file.finish();
  }
}

CONCINO_INLINE void folder_files::put_back() noexcept {
  for (const std::unique_ptr<part>& p : parts_)
    if (p->file.is_committed()) p->file.undo();
  for (std::size_t i = 0; i < num_removed_; ++i) rename_file(removed_backups_[i], removed_[i]);
}

CONCINO_INLINE void folder_files::commit() {
  finish();
  try {
    for (const std::unique_ptr<part>& p : parts_) p->file.commit();
    for (; num_removed_ < removed_.size(); ++num_removed_)
      if (!rename_file(removed_[num_removed_], removed_backups_[num_removed_]) && errno != ENOENT)
        throw_io_error(removed_[num_removed_], "cannot be removed", errno);
  } catch (...) {
    put_back();
    throw;
  }
  is_committed_ = true;
  for (const std::string& backup : stale_) remove_file(backup);
}

}  // namespace concino::detail
