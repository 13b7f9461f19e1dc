#include "cmd/completion_scripts.h"

#include "cmd/complete.h"

#include <stddef.h>
#include <string.h>

/* bash cuts words at "=" and ":" too. So the line is cut here at blanks alone, and what bash takes for an
 * earlier word is taken off the front of each reply. */
static const char bash[] =
    "# Completion of magichour's command lines, for bash. It is made by `magichour help --completion bash`.\n"
    "_magichour() {\n"
    "    local line=${COMP_LINE:0:COMP_POINT} words reply front last path\n"
    "    read -a words <<<\"$line\"\n"
    "    [[ $line == *[[:space:]] ]] && words+=('')\n"
    "    last=${words[${#words[@]} - 1]}\n"
    "    front=$last\n"
    "    while [[ -n $front && $COMP_WORDBREAKS != *\"${front: -1}\"* ]]; do front=${front%?}; done\n"
    "    COMPREPLY=()\n"
    "    while IFS= read -r reply; do\n"
    "        case $reply in\n"
    "        :files | :folders)\n"
    "            compopt -o filenames 2>/dev/null\n"
    "            path=$last\n"
    "            [[ $last == --*=* ]] && path=${last#*=}\n"
    "            [[ $reply == :files ]] && reply=-f || reply=-d\n"
    "            while IFS= read -r path; do COMPREPLY+=(\"$path\"); done < <(compgen \"$reply\" -- "
    "\"$path\")\n"
    "            ;;\n"
    "        *)\n"
    "            reply=${reply%%$'\\t'*}\n"
    "            [[ $reply == *= ]] && compopt -o nospace 2>/dev/null\n"
    "            COMPREPLY+=(\"${reply#\"$front\"}\")\n"
    "            ;;\n"
    "        esac\n"
    "    done < <(\"${words[0]/#\\~/$HOME}\" " COMPLETE_WORD " \"${words[@]:1}\" 2>/dev/null)\n"
    "}\n"
    "complete -F _magichour magichour\n";

static const char zsh[] =
    "#compdef magichour\n"
    "# Completion of magichour's command lines, for zsh. It is made by `magichour help --completion zsh`.\n"
    "_magichour() {\n"
    "    local reply\n"
    "    local -a replies values shown open opened\n"
    "    replies=(\"${(@f)$(\"${(e)~words[1]}\" " COMPLETE_WORD
    " \"${(@Q)words[2,CURRENT-1]}\" \"${(Q)PREFIX}\" 2>/dev/null)}\")\n"
    "    for reply in $replies; do\n"
    "        case $reply in\n"
    "        :files | :folders) ;;\n"
    "        *=$'\\t'* | *=) open+=(\"${reply%%$'\\t'*}\") opened+=(\"${reply/$'\\t'/  -- }\") ;;\n"
    "        *) values+=(\"${reply%%$'\\t'*}\") shown+=(\"${reply/$'\\t'/  -- }\") ;;\n"
    "        esac\n"
    "    done\n"
    "    (( $#values )) && compadd -l -d shown -a values\n"
    "    (( $#open )) && compadd -l -S '' -d opened -a open\n"
    "    if (( $replies[(I):fi*] + $replies[(I):fo*] )); then\n"
    "        compset -P '--*='\n"
    "        (( $replies[(I):fo*] )) && _files -/ || _files\n"
    "    fi\n"
    "}\n"
    "if [[ $funcstack[1] == _magichour ]]; then _magichour; else compdef _magichour magichour; fi\n";

static const char fish[] =
    "# Completion of magichour's command lines, for fish. It is made by `magichour help --completion fish`.\n"
    "function __magichour_complete\n"
    "    set -l words (commandline -opc)\n"
    "    set -l last (commandline -ct)\n"
    "    for reply in ($words[1] " COMPLETE_WORD " $words[2..-1] \"$last\" 2>/dev/null)\n"
    "        switch $reply\n"
    "            case :files\n"
    "                __fish_complete_path $last\n"
    "            case :folders\n"
    "                __fish_complete_directories $last\n"
    "            case '*'\n"
    "                echo $reply\n"
    "        end\n"
    "    end\n"
    "end\n"
    "complete -c magichour -f -a '(__magichour_complete)'\n";

const char *completion_script(const char *shell) {
    static const char *const scripts[][2] = {{"bash", bash}, {"zsh", zsh}, {"fish", fish}};
    for (size_t i = 0; i < sizeof scripts / sizeof *scripts; i++) {
        if (strcmp(scripts[i][0], shell) == 0) return scripts[i][1];
    }
    return NULL;
}
