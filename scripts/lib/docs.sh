# shellcheck shell=bash
# docs: the documentation site, built from docs/ and the descriptions of the interfaces, and served on this machine.

readonly DOCS=$TOOLS/docs
readonly DOCS_MARK=.dronemap-docs

command_docs() {
    local folder=$DOCS/html port
    load_settings
    case ${1:-} in
        "") (($# == 0)) || fail "$EXIT_USAGE" "docs does not know ''. See ./dronemap help" ;;
        --build)
            (($# == 2)) || fail "$EXIT_USAGE" "--build needs one folder. See ./dronemap help"
            folder=$(realpath -m -- "$2")
            ;;
        *) fail "$EXIT_USAGE" "docs does not know '$1'. See ./dronemap help" ;;
    esac
    if (($# == 0)); then
        port=$(port_setting DRONEMAP_DOCS_PORT 8000) || exit
        check_port tcp "$port" "the documentation" DRONEMAP_DOCS_PORT docs
    fi
    is_folder_for_docs "$folder" ||
        fail "$EXIT_USAGE" "$folder has files that are no documentation site; a build would delete them. Name an empty folder or a new one."
    make_tools_folder
    take_lock
    has_venv || install_packages python3-venv
    provide_docs_python
    build_docs "$folder"
    if (($# > 0)); then return; fi
    serve_docs "$folder" "$port"
}

# The build empties its folder first, but for hidden files: one of them says that the rest may go.
is_folder_for_docs() { # FOLDER
    [[ ! -e $1 || -f $1/$DOCS_MARK || (-d $1 && -z $(ls -A -- "$1")) ]]
}

provide_docs_python() {
    local wanted log=$TOOLS/logs/docs-python.log
    wanted=$(hash_of site/requirements.txt)
    if [[ $(stamp_of docs) == "$wanted" && -x $DOCS/venv/bin/python ]]; then return; fi
    WORK="installing the programs that build the documentation"
    step "Installing what builds the documentation into .tools/docs"
    rm -rf "$DOCS/venv"
    mkdir -p "$DOCS"
    run_logged "$log" no_progress make_venv "$DOCS/venv" -r "$ROOT/site/requirements.txt" ||
        fail_from_log "$log" "$EXIT_NETWORK" "The programs that build the documentation could not be installed."
    echo "$wanted" >"$APP/docs.stamp"
    WORK=""
}

build_docs() { # FOLDER
    local log=$TOOLS/logs/docs.log
    WORK="building the documentation"
    step "Building the documentation"
    mkdir -p -- "$1" && touch -- "$1/$DOCS_MARK" || fail "$EXIT_RIGHTS" "The user $(id -un) may not write to $1."
    run_logged "$log" no_progress env -C "$ROOT/site" NO_MKDOCS_2_WARNING=1 PYTHONDONTWRITEBYTECODE=1 \
        "$DOCS/venv/bin/python" -m mkdocs build --quiet --site-dir "$1" ||
        fail_from_log "$log" "$EXIT_BUILD" "The documentation does not build."
    WORK=""
    step "Built the documentation in $1"
}

# The lock is for those who build: who reads keeps nobody from it.
serve_docs() { # FOLDER PORT
    step "The documentation is at http://$LOOPBACK:$2 (Ctrl-C ends it)"
    exec {LOCK}>&-
    run_logged "$TOOLS/logs/docs-requests.log" no_progress \
        "$DOCS/venv/bin/python" -u -m http.server --bind "$LOOPBACK" --directory "$1" "$2" ||
        fail_from_log "$TOOLS/logs/docs-requests.log" "$EXIT_FAILED" "The documentation is served no more."
}
