"""The links of a Markdown page and the places that one can lead to: for scripts/check-links and scripts/site."""
import re
import unicodedata
import urllib.parse

FENCE = re.compile(r"^ *(?P<fence>`{3,}|~{3,}).*?^ *(?P=fence)[`~]*[ \t]*$", re.M | re.S)
COMMENT = re.compile(r"<!--.*?-->", re.S)
CODE = re.compile(r"(?<!`)(`+)(?!`)(.+?)(?<!`)\1(?!`)", re.S)
TARGET = re.compile(r"\]\(([^()\s]+)\)")
HEADING = re.compile(r"^#{1,6} +(.*?)(?: +#+)?$", re.M)
NAMED = re.compile(r"<a (?:id|name)=\"([^\"]+)\"")
ELSEWHERE = re.compile(r"[a-z][a-z0-9+.-]*:", re.I)


def without_code(text):
    """The text with code and comments blanked, so that every other character keeps its place."""
    def blank(found):
        return re.sub(r"[^\n]", "x", found[0])
    for what in (FENCE, COMMENT, CODE):
        text = what.sub(blank, text)
    return text


def links(text):
    """The links and pictures of a page: where each begins and ends, its text and its target."""
    bare = without_code(text)
    for found in TARGET.finditer(bare):
        start, depth = found.start(), 1
        while depth and start > 0:
            start -= 1
            depth += {"]": 1, "[": -1}.get(bare[start], 0)
        if depth == 0:
            picture = start > 0 and bare[start - 1] == "!"
            yield start - picture, found.end(), text[start + 1:found.start()], found[1]


def leads_elsewhere(target):
    """Whether the target is on another machine, so that nothing here can say if it exists."""
    return bool(ELSEWHERE.match(target)) or target.startswith("//")


def split(target):
    """The path and the anchor of a target; either may be empty."""
    path, _, anchor = target.partition("#")
    return urllib.parse.unquote(path), urllib.parse.unquote(anchor)


def slug(heading):
    """The anchor that a code host gives a heading, the text of which this is."""
    kept = "".join(letter for letter in heading.lower()
                   if letter in " -_" or unicodedata.category(letter)[0] in "LN")
    return kept.strip().replace(" ", "-")


def unique(name, taken):
    """`name`, with a number if it is taken; it is taken then."""
    count = taken.get(name, 0)
    taken[name] = count + 1
    return f"{name}-{count}" if count else name


def plain(markdown):
    """A line of Markdown without its marks."""
    markdown = re.sub(r"!?\[((?:[^\[\]]|\[[^\]]*\])*)\]\([^)]*\)", r"\1", markdown)
    return re.sub(r"[`*]", "", markdown)


def anchors(text):
    """The anchors of a page: those of its headings, and those that it names."""
    bare = FENCE.sub("", COMMENT.sub("", text))
    taken = {}
    return {unique(slug(plain(found[1])), taken) for found in HEADING.finditer(bare)} | set(NAMED.findall(bare))
