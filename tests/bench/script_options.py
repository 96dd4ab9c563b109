"""Words of the command line, for the scripts of this folder."""


def option(words, name, otherwise):
    """Takes `name` and the word behind it out of the list; that word, or `otherwise`."""
    if name not in words:
        return otherwise
    at = words.index(name)
    value = words[at + 1]
    del words[at:at + 2]
    return value
