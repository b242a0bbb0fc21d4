"""The tables that matching_experiments has written, as Python sees them."""
from tables import Results

# In the order of the paper, then those that it asks for. Colours by Okabe and Ito, which people see
# apart whatever their eyes; dashes tell them apart without any colour.
MATCHERS = {
    'hill_climbing': ('hill climbing', '#E69F00', (0, (1, 1))),
    'particles': ('particle sampling', '#CC79A7', (0, (3, 1, 1, 1))),
    'icp': ('ICP', '#D55E00', (0, (4, 1.5))),
    'point_to_line': ('point to line', '#56B4E9', (0, (5, 1, 1, 1))),
    'scan_to_map': ('scan to map', '#009E73', (0, (2, 1))),
    'correlative': ('correlative', '#0072B2', '-'),
    'information': ('best the noise allows', '#888888', ':'),
    'pcl_icp': ('PCL ICP', '#000000', '-'),
    'pcl_ndt': ('PCL NDT', '#999999', '-'),
}
WORLDS = {'lab': 'lab', 'swarmlab': 'SwarmLab', 'office': 'office'}

SOURCES = {'intel': 'Intel log, 180 beams', 'lab': 'lab, simulated URG, 683 beams'}


def labelOf(matcher):
    return MATCHERS[matcher][0] if matcher in MATCHERS else matcher.replace('_', ' ')


def styleOf(matcher):
    """What matplotlib draws a matcher with."""
    _, colour, dashes = MATCHERS.get(matcher, (matcher, '#F0E442', '-'))
    return {'color': colour, 'linestyle': dashes, 'label': labelOf(matcher)}


def inOrder(matchers):
    known = list(MATCHERS)
    return sorted(matchers, key=lambda name: known.index(name) if name in known else len(known))


def byMatcher(rows):
    """Matcher -> its rows, in the order of MATCHERS."""
    found = {row['matcher']: [] for row in rows}
    for row in rows:
        found[row['matcher']].append(row)
    return {name: found[name] for name in inOrder(found)}


class MatchingResults(Results):
    """A folder of tables: `<what>_<world>[_<noise>].csv`."""

    def worlds(self, what):
        """Worlds that have a table, in the order of WORLDS."""
        names = {path.stem[len(what) + 1:].split('_')[0]
                 for path in self.folder.glob(what + '_*.csv')}
        known = [name for name in [*WORLDS, 'intel'] if name in names]
        return known + sorted(names - set(known))
