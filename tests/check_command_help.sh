#!/usr/bin/env bash
# Every option that --help names is in the manual pages, and those of brume are offered by its
# completions for bash, zsh and fish (these two where they are installed).
#   check_command_help.sh BRUME FOLDER [EDITOR EDITOR_PAGE]
# FOLDER is what tools/make-command-help has written.
set -euo pipefail

brume=$1 folder=$2 failed=
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
complain() {
  echo "$1"
  failed=yes
}
# The options at the beginnings of lines; what else a text mentions may be another command's.
options_of() {
  "$@" --help | sed -nE 's/^  (-[^ ,]+(, ?-[^ ,]+)?).*/\1/p' | grep -oE -- '-[A-Za-z-]+' | sort -u
}
# Texts are searched by the shell itself: a thousand starts of grep take seconds.
in_page() {
  [[ $2 == *"\\fB${1//-/\\-}\\fR"* ]] || complain "the page of $3 lacks $1"
}
has_line() {
  [[ $'\n'$1$'\n' == *$'\n'"$2"$'\n'* ]]
}

# shellcheck source=/dev/null
source "$folder/brume.bash"
offered_by_bash() (
  set +e  # as in a shell with keys
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
  _brume
  printf '%s\n' "${COMPREPLY[@]}"
)
offered_by_fish() {
  fish --no-config -c "source $folder/brume.fish; complete -C '$*'" | cut -f 1
}
# What each shell offers after these words must have the last argument.
offers() {
  local words=("${@:1:$#-1}") expected=${*: -1}
  grep -qxE -- "$expected" <<< "$(offered_by_bash "${words[@]}")" ||
    complain "bash: lacks $expected after ${words[*]}"
  if command -v fish > /dev/null; then
    grep -qxE -- "$expected" <<< "$(offered_by_fish "${words[@]}")" ||
      complain "fish: lacks $expected after ${words[*]}"
  fi
}

page=$(< "$folder/brume.1")
for option in $(options_of "$brume"); do
  in_page "$option" "$page" brume
  offers brume "${option%%[a-z]*}" "$option"
done
commands=$("$brume" --help | sed -n '/^Subcommands/,$ s/^  \([a-z]*\) .*/\1/p')
[ -n "$commands" ] || complain "brume: names no subcommands"
for command in $commands; do
  offers brume "${command:0:2}" "$command"
  options=$(options_of "$brume" "$command")
  page=$(sed -n "/^\.SH BRUME ${command^^}/,/^\.SH BRUME/p" "$folder/brume.1")
  zsh_offers=$(sed -n "/^    $command)/,/;;$/p" "$folder/brume.zsh")
  bash_offers=$(offered_by_bash brume "$command" -)
  if command -v fish > /dev/null; then
    fish_offers=$(offered_by_fish brume "$command" - 
      offered_by_fish brume "$command" --)
  fi
  for option in $options; do
    in_page "$option" "$page" "brume $command"
    word="['{,]${option}['},[]"
    [[ $zsh_offers =~ $word ]] || complain "zsh: lacks $option of brume $command"
    has_line "$bash_offers" "$option" || complain "bash: lacks $option of brume $command"
    if command -v fish > /dev/null; then
      has_line "$fish_offers" "$option" || complain "fish: lacks $option of brume $command"
    fi
  done
done

# Values, and files by their extension.
cd "$work"
mkdir folder
touch one.brume two.exr three.txt
offers brume render --airlight '' paper
offers brume render --airlight pa paper
offers brume fit --up '' z
offers brume render '' one.brume
offers brume compare '' two.exr
offers brume gather one.brume '' 'folder/?'

# zsh completes in a terminal only: a key shows what a line becomes.
if command -v zsh > /dev/null; then
  mkdir functions
  cp "$folder/brume.zsh" functions/_brume
  cat > completed.zsh <<'ZSH'
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell 'fpath=($PWD/functions $fpath); autoload -Uz compinit; compinit -u -D
completed() { zle complete-word; print -r -- "<""<$BUFFER>"">"; BUFFER= }
zle -N completed; bindkey "^X" completed; print "rea""dy"'
zpty -r shell output '*ready*'
for line in "$@"; do
  zpty -w -n shell "$line"$'\x18'
  zpty -r shell output '*<<*>>*'
  print -r -- "${${${output##*<<}%%>>*}% }"
done
ZSH
  lines=('brume inf' 'brume render --sl' 'brume render --airlight pap' 'brume render o'
    'brume compare tw' 'brume gather one.brume fol')
  expected='brume info
brume render --slices
brume render --airlight paper
brume render one.brume
brume compare two.exr
brume gather one.brume folder/'
  [ "$(timeout 60 zsh -f completed.zsh "${lines[@]}")" = "$expected" ] ||
    complain "zsh: completes otherwise"
fi

if [ $# -gt 2 ]; then
  page=$(< "$4")
  for option in $(QT_QPA_PLATFORM=offscreen options_of "$3"); do
    in_page "$option" "$page" brume-editor
  done
fi
[ -z "$failed" ]
