# shellcheck shell=bash
# Sourced by tools/check-release and tools/check-packages: a clean Debian in a chroot of its own, the
# last commit in it, and steps whose times are kept. They have read their options, $given, into
# $suite, $root, $keep and $mirror.

program=$(basename -- "$0")
tree=$(git -C "$(dirname -- "${BASH_SOURCE[0]}")" rev-parse --show-toplevel)
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo > /dev/null || wrong "a chroot needs root, or sudo"
  exec sudo --preserve-env=BRUME_DEBIAN_MIRROR -- "$tree/tools/$program" "${given[@]}"
fi
command -v debootstrap > /dev/null || wrong "debootstrap is missing: apt-get install debootstrap"
if [ -n "$(git -C "$tree" status --porcelain --untracked-files=no)" ]; then
  echo "$program: note: the tree has changes that are not committed; they are not tried."
fi

if [ -z "$mirror" ]; then
  mirror=$({ apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 2> /dev/null || true; } |
    grep -m 1 -E '/debian/?$' || true)
fi

if [ -n "$root" ]; then
  mkdir -- "$root"
  root=$(realpath -- "$root")
else
  root=$(mktemp -d "/var/tmp/brume-$suite.XXXXXX")
fi
chmod 755 "$root"
log=$root.log
chroots=("$root")

# Runs a command in the chroot. All mounts belong to a namespace of their own and end with the
# command, so that removing the chroot can never reach what was mounted in it.
inside() {
  # shellcheck disable=SC2016
  unshare --mount --pid --fork --kill-child -- sh -euc '
    root=$1
    shift
    mount -t proc proc "$root/proc"
    mount --rbind /sys "$root/sys"
    mount --rbind /dev "$root/dev"
    mount -t tmpfs -o mode=1777 tmpfs "$root/dev/shm"
    exec env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
      chroot "$root" "$@"' sh "$root" "$@"
}

finish() {
  local status=$?
  if [ -n "$keep" ]; then
    printf "$program: the chroot is kept: chroot %s\n" "${chroots[@]}"
  else
    rm -rf --one-file-system -- "${chroots[@]}"
  fi
  [ "$status" -eq 0 ] || echo "$program: $suite failed; all that was said is in $log" >&2
}
trap finish EXIT
trap 'exit 130' INT TERM

# One step: its output goes to the log, its times to the table.
times=()
step() {
  local name=$1 start=$EPOCHREALTIME status=0
  shift
  echo "$program: $name ..."
  echo "== $name" >> "$log"
  "$@" >> "$log" 2>&1 < /dev/null || status=$?
  if [ "$status" -ne 0 ]; then
    tail -n 30 "$log" >&2
    echo "$program: $name ended with $status; its last words are above." >&2
    exit 1
  fi
  local seconds=$(((${EPOCHREALTIME/./} - ${start/./}) / 1000000))
  times+=("$(printf '%-34s %3d min %02d s' "$name" $((seconds / 60)) $((seconds % 60)))")
}

debian() {
  debootstrap --variant=minbase "$suite" "$root" ${mirror:+"$mirror"}
  # The way to the mirror: proxies, and how dates are judged.
  apt-config dump | grep -E '^Acquire::((http|https)::.*Proxy|Check-)' \
    > "$root/etc/apt/apt.conf.d/90clean-debian" || true
}

clone() {
  git clone --no-hardlinks "$tree" "$root/root/brume"
  git -C "$root/root/brume" log -1 --oneline
}

: > "$log"
