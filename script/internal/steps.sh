# shellcheck shell=bash
# Sourced by the scripts: they are lists of steps, which are announced, timed, and summed up at the end.

steps=() # one line of the summary each
failed=0

# step <title> <command ...>: runs one command; its status is that of the step.
step()
{
  local title=$1 start=$SECONDS status=0 outcome=ok
  shift
  printf '\n==== %s\n' "$title"
  "$@" || status=$?
  if (( status != 0 )); then
    outcome=FAILED
    failed=1
  fi
  local seconds=$(( SECONDS - start ))
  printf -- '---- %s: %s, %d s\n' "$title" "$outcome" "$seconds"
  steps+=("$(printf '%-60s %-6s %5d s' "$title" "$outcome" "$seconds")")
  return $status
}

# Prints the steps, and exits: with 1 if one of them failed.
finish()
{
  printf '\n==== Summary\n'
  printf '%s\n' "${steps[@]}"
  printf '%-60s %-6s %5d s\n' "all" "$( (( failed )) && echo FAILED || echo ok )" "$SECONDS"
  exit $failed
}

# configure <preset>, build <preset> [target ...], run_tests <preset>
configure()
{
  # Ninja compiles a program while the libraries that it is linked with are being built: make waits. (Where a folder was
  # configured for another, that stays.)
  command -v ninja > /dev/null && export CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja}
  local warnings_as_errors=OFF # sanitizers make the compiler warn of what is not so
  [[ $1 != *san ]] && warnings_as_errors=ON
  # TBB's allocator, which libtbb-dev brings, saves compilers a twentieth of their time
  local launcher=${CMAKE_CXX_COMPILER_LAUNCHER:-} proxy=libtbbmalloc_proxy.so.2
  [[ -z $launcher && $(/sbin/ldconfig -p 2> /dev/null) == *$proxy* ]] && launcher="env;LD_PRELOAD=$proxy"
  CMAKE_CXX_COMPILER_LAUNCHER=$launcher cmake --preset "$1" -D SHAPE_CHARACTERISTICS_WARNINGS_AS_ERRORS=$warnings_as_errors
}
build() { cmake --build --preset "$1" --parallel "$(parallel_jobs 1)" ${2:+--target "${@:2}"}; } # one more, for who waits
run_tests() { ctest --preset "$1" --parallel "$(parallel_jobs)"; }

# As many as there are processors, and so many more, as far as memory goes: a compiler that reads CGAL and Eigen takes up to
# 2.5 GB.
parallel_jobs()
{
  local jobs memory
  jobs=$(( $(nproc) + ${1:-0} ))
  memory=$(awk '/^MemAvailable:/ { print int($2 / 2500000) }' /proc/meminfo)
  echo $(( memory < 1 ? 1 : memory < jobs ? memory : jobs ))
}
