# Finds headers that call the operating system, start threads or use atomics outside the one file for it. What each of these files does has a plain version in
# standard C++ in the same file, or in the file beside it, for systems without it. The headers that several files below name are for needs that have no more
# than that in common.
# usage: awk -f check_system_headers.awk headers...     Prints file:line: what it includes; the exit code is 1 where something is wrong.

BEGIN {
  # files, atomic replacement of files, real paths: POSIX, and the standard library
  allow("posix_files.ipp", "fcntl.h sys/mman.h sys/stat.h unistd.h")
  allow("posix_atomic_file.ipp", "fcntl.h sys/file.h sys/stat.h unistd.h")
  allow("standard_files.ipp", "filesystem")
  # threads, the processors that a process may use
  allow("parallel.ipp", "thread latch sched.h")
  # whether a terminal is there, and how wide it is
  allow("terminal.ipp", "sys/ioctl.h unistd.h")
  # a child process with limits, in which another library may crash
  allow("tetgen_child.hpp", "csignal fcntl.h sys/mman.h sys/prctl.h sys/resource.h sys/wait.h time.h unistd.h")
  # what CGAL's mesher looks at, to stop
  allow("cgal_mesh_in_surface.hpp", "atomic")
  n = split("barrier condition_variable csetjmp csignal future semaphore shared_mutex stop_token", names, " ")
  for (i = 1; i <= n; i++) guarded[names[i]] = 1
  # names of headers of POSIX, Linux, macOS and Windows
  system_headers = "^((arpa|linux|mach|net|netinet|sys)/.*|aio|copyfile|crt_externs|ctype|direct|dirent|dlfcn|errno|execinfo|fcntl|fenv|fnmatch|ftw|getopt|glob|grp|" \
                   "iconv|ifaddrs|intrin|io|langinfo|libgen|libproc|limits|link|locale|malloc|math|memory|monetary|mqueue|ndbm|netdb|nl_types|numa|poll|process|psapi|" \
                   "pthread|pwd|regex|sched|search|semaphore|setjmp|share|signal|spawn|stddef|stdint|stdio|stdlib|string|strings|stropts|syslog|tar|termios|time|ucontext|" \
                   "ulimit|unistd|utime|utmpx|wchar|wctype|windows|winsock2|wordexp|x86intrin|[a-z]*mmintrin|immintrin)(\\.h)?$"
}

function allow(file, headers,    names, n, i) {
  n = split(headers, names, " ")
  for (i = 1; i <= n; i++) {
    allowed[file, names[i]] = 1
    guarded[names[i]] = 1
  }
}

/^[ \t]*#[ \t]*include[ \t]*</ {
  header = $0
  sub(/^[^<]*</, "", header)
  sub(/>.*$/, "", header)
  if (!(header in guarded) && !(header ~ /\.h$/ && header ~ system_headers)) next
  file = FILENAME
  sub(/^.*\//, "", file)
  if ((file, header) in allowed) next
  print FILENAME ":" FNR ": <" header ">"
  found = 1
}
END { exit found }
