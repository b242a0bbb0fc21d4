"""How tables get into a page."""
import re

MARKER = re.compile(r'(<!-- begin (\w+) -->\n).*?(<!-- end \2 -->)', re.DOTALL)


def fillPage(text, sections):
    """Replaces what stands between `<!-- begin name -->` and `<!-- end name -->`.

    A section without results keeps what it has.
    """
    def replaced(match):
        content = sections.get(match.group(2))
        return match.group(0) if content is None else match.group(1) + content + match.group(3)
    return MARKER.sub(replaced, text)


def markdownTable(head, rows):
    lines = ['| ' + ' | '.join(head) + ' |', '|' + ' --- |' * len(head)]
    lines += ['| ' + ' | '.join(str(cell) for cell in row) + ' |' for row in rows]
    return '\n'.join(lines) + '\n'


def percent(share, digits=1):
    return f'{100 * share:.{digits}f} %'
