#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Find non-idiomatic English and private vocabulary in a source tree.

usage: prose.py [--top N] [--score] [--show NAME] [--root DIR] [PATH...]

Run it in the project's root. PATH limits the scan to files or directories;
without it every tracked file is scanned. The script reads comments, doc
strings, message strings, ParaView tooltips and labels, and Markdown text,
splits them into sentences and counts the patterns in SHAPES, PHRASES, WORDS,
BRITISH and NAME_WORDS below. It prints

  * a table: pattern, number of hits, suggestion, three examples;
  * totals per directory;
  * a score: hits per 1,000 words of prose. Overlapping hits count once.

  --top N      show only the N most frequent patterns
  --score      print the score alone
  --show NAME  list every hit of one pattern as FILE:LINE: text
  --root DIR   scan DIR instead of the current directory

The exit status is always 0. A hit is a hint, not an error: read the sentence
before changing it. To accept a use for good, put the literal text into ALLOW.
"""
import ast
import collections
import io
import os
import re
import subprocess
import sys
import tokenize

MAX_CLASS_COMMENT_LINES = 60
MAX_SENTENCE_WORDS = 40
MAX_README_WORDS = 1600

C_SUFFIXES = (".h", ".hpp", ".hxx", ".txx", ".cxx", ".cpp", ".cc", ".c", ".glsl")
SKIPPED_DIRECTORIES = {"external", "third_party", "ThirdParty", "thirdparty", "build", "node_modules"}
SKIPPED_FILES = {"prose.py"}  # these quote the patterns

# ---------------------------------------------------------------------------
# Patterns. Each entry: name, regular expression, suggestion, and optionally a
# regular expression that the file's path must match. Patterns are matched
# against single sentences, so "^" is the start of a sentence. Inline code and
# \a arguments read as IDN in the sentence. The first pattern that matches a
# piece of text wins, so specific patterns come first.

# Applied to sentences, not to headings, table cells and labels.
SHAPES = [
    ("starts: What", r"^what\b(?!['’]s\b)(?!.*\?$)", "start with a noun or a verb, not a nominal clause"),
    ("starts: Of", r"^of (?!course\b)", "move the 'of' phrase behind its noun"),
    ("starts: Where", r"^where\b(?! (possible|applicable|appropriate|available|needed|necessary|supported)\b)(?!.*\?$)",
     "'If ...', 'Position of ...'"),
    ("starts: That/Those", r"^(that|those) (of|that|which|with|in|where|not|whose|at|by)\b", "repeat the noun"),
    # Only in public headers, tooltips and documents; fine for private bool members.
    ("starts: Whether", r"^whether\b", "'If true, ...', 'Turn on/off ...'", r"(^|/)vtk[^/]*\.h$|\.xml$|\.md$"),
    ("starts: How", r"^how (far|near|much|often|many|long|large|wide|deep|soft|coarse|thick|fast|high|strongly|evenly|close|light|the|a|an|it|each|one)\b(?!.*\?$)",
     "name the quantity: 'Distance from ...', 'Number of ...'"),
    ("starts: Who/Whoever", r"^(who|whoever|whose|whichever|wherever|whatever|nobody|nothing|(?-i:None|none)|neither)\b(?! (?:to (?:do|add)|the names?|of the functions)\b)(?!.*\?$)", "name the subject"),
    ("starts: By/With what", r"^(by|with|in|on|from|for|to|at|over|through) (what|which|whom|how)\b(?!.*\?$)", "name the thing"),
    ("starts: inverted There/Else", r"^(there (?!(is|are|was|were|has|have|may|can|could|should|must|will|would|might|seems?|exists?|['’]s)\b)|else\b)", "subject first; 'Otherwise, ...'"),
    ("starts: So/Thus ... verb", r"^so (is|are|do|does|has|have|it is|a|an|no)\b", "'Therefore', or join the sentences"),
]

PHRASES = [
    ("Returns what is wrong", r"\b(?:returns?|reports?|gets?|names?|says?|tells?|is|of|and|with) what is wrong\b(?: with [\w ]+)?(?:,? or nothing)?", "'Returns an error message, or an empty string'"),
    ("returns what/how/why", r"\breturns? (?:what|how|why|where|who|that of|those|none|nothing)\b", "'Returns the number of', 'the position of'"),
    ("..., or nothing/none", r",? or (?:nothing|none)\b", "'or an empty string', 'or null'"),
    ("what is/was/has", r"\bwhat (?:is|was|are|were|has|have|had|does|did)\b(?! (?:the|this|that|new)\b.*\?$)", "name it: the value, the error, the data"),
    ("prep + what", r"\b(?:by|of|for|from|with|to|in|on|at|over|than|through|behind|beside|between|and|or|not|but|is|are|just|all|about) what\b(?! (?:is|was|are|were|has|have|had|does|did)\b)(?!ever)", "name it"),
    ("verb + what it/a/the", r"(?<!^)\bwhat (?:it|a|an|the|they|one|its|each|no|some|all|both|others?|several|this|these|lies|comes|goes|stays|remains|leaves|makes|gives|takes|needs|follows|differs|changed|changes|others)\b(?!.*\?$)", "name it"),
    ("x where (null/false/0/empty where)", r"\b(?:null|true|false|empty|nothing|none|NaN|zero|IDN|[0-9]+) (?:where|without|for none)\b", "'if'"),
    ("where there is/are", r"\bwhere there (?:is|are|was|were)\b", "'if there is'"),
    ("where it/that/they is/has", r"\bwhere (?:it|that|they|this|all|those|these|one|none|both|nothing|no|some|several) (?:is|are|was|were|has|have|had|does|do|can|may|lies?|goes|takes?|gives?|needs?|ends?)\b", "'if', 'when'"),
    ("where (no|none|not)", r"\bwhere (?:no|none|not|nothing|nobody|neither|only|fewer|more)\b", "'if no'"),
    ("those/that of|that|which", r"\bthose (?:of|that|which|with|in|where|not|whose|at|by|from|on|to|around|between|behind|outside|inside)\b|\b(?:is|are|as|than|and|with|from|to|of|by|in|for|over|at|equal|like|or|on) that of\b", "repeat the noun"),
    ("of its/their/one's own", r"\bof (?:its|their|his|our|your) own\b", "'its own x', 'separate'"),
    ("and of/by/in the (split coordination)", r"(?:,| and| or| but| than| not) of (?:the|those|each|all|its|a|an|their|one|two|every|that|which|any|both|no|these|this)\b", "repeat the head noun or rephrase"),
    ("of which/by which/whom", r"\b(?:of|by|from|through|after|over|on) (?:which|whom)\b", "use 'whose', 'that', or split the sentence"),
    ("or nothing / nothing of", r"\b(?:and|where|with|as|gives?|changes?|has|have|leaves?|holds?|finds?|adds?|casts?|costs?|of|by|which|sees?|draws?|takes?) nothing\b|\bnothing (?:of|is (?:drawn|asked|known|taken|kept|made|left|lost|written|cut|there|scattered|read|refined|wrong|missing)|but|comes|goes|there|has|reads|where)\b", "'does not ...', 'no x'"),
    ("but for", r"\bbut for\b", "'except', 'apart from'"),
    ("anew", r"\banew\b", "'again', 're-'"),
    ("alone (= only)", r"(?<!stand)(?<!stand-)(?<!let )(?<!leave )(?<!leaves )(?<!left )(?<!stand )\balone\b", "'only'"),
    ("else (adverb)", r"(?:[,;(:] |\bor |\band )else\b(?! if\b)|\belse (?:it|they|the|a|an|is|are|to|by|in|as|where|from|of)\b", "'otherwise'"),
    ("so many/so far/so long", r"\b(?:for|of|in|to|by|after|at|with|over|or|up to|only) so (?:many|much|few|far|long)\b|\bso (?:many|few) (?:\w+s)\b(?! that\b)", "give the number's name"),
    ("has it/has them", r"\b(?:has|have|had) (?:it|them|none|both|those)\b(?! (?:been|own|its|to|more|less|another|already|installed|set|unnamed)\b)(?=[ ,.;:)]|$)", "name the object"),
    ("as x has/takes it", r"\bas (?:\S+ ){1,4}?(?:has|have|takes?|sees?|gives?|finds?|wants?|knows?|says?|keeps?|holds?) (?:it|them)\b", "'in the format of', 'as in'"),
    ("tells of/which/whether", r"\b(?:tells?|told|telling) (?:of|which|whether|where|what|how|apart|by|the|a|all|its|each|no|it|them|from|that|on|only|more|most|something|nothing|when|so|in)\b", "'reports', 'indicates', 'determines'"),
    ("is told/asked/said/wanted", r"\b(?:is|are|was|were|be|been|being|has been|not|it|what|as|last|one|those) (?:told|asked|said|wanted|warned|refused|forgotten|promised|spared|met)\b", "'is set', 'is requested', 'is reported', 'is rejected'"),
    ("asks/wants/says/knows (code as speaker)", r"\b(?:asks|wants|says|knows|forgets|remembers|refuses|answers|promises|likes|learns|lets one|sees|thinks|hears|speaks|pays|bids)\b", "'queries', 'requires', 'reports', 'stores', 'rejects'"),
    ("asked for", r"\basked (?:for|of|to|by)\b|\bask(?:s|ing)? (?:for|of)\b", "'requested'"),
    ("no more than / no less", r"\b(?:no|not) (?:more|less|fewer|farther|further|nearer|larger|longer|slower|faster|other|thicker|wider|finer) than\b", "'at most', 'at least', 'within'"),
    ("not till/until", r"\bnot (?:till|until)\b|\btill\b", "'before', 'only after'"),
    ("the most/the least (noun)", r"\bthe (?:most|least|fewest) (?=that|which|of|is|are|was|it|a|an|the|there)|\b(?:are|is|of|at|be) the (?:most|least|fewest)\b(?=[.,;:)]|$)|\bthe least (?:\w+)\b", "'the maximum', 'the smallest'"),
    ("in vain / for nothing", r"\bin vain\b|\bfor nothing\b|\bto no end\b", "'without effect'"),
    ("whatever/whichever/whoever", r"\b(?:whatever|whichever|whoever|wherever|however (?:many|much|few|far|long|large|small))\b", "'regardless of', 'for any'"),
    ("is none/has none", r"(?-i:\b(?:is|are|was|were|has|have|had|with|and|needs?|takes?|gives?|casts?|for|to|from|be) none\b|\bnone (?:where|there|that|has|have|at|in|with|without|left)\b)", "'does not exist', 'there is no x', 'not available'"),
    ("is no x", r"(?<!there )(?<!here )(?<!which )\b(?:is|are|was|were|be|as|that is|which is) no (?!longer\b|more\b|less\b|need\b|guarantee\b|way\b|limit\b|such\b|different\b|larger\b|point\b|issue\b|problem\b|doubt\b|one\b|reason\b|data\b|input\b)[a-z]+", "'is not a x'"),
    ("is there / is not there", r"\b(?:is|are|was|were|it's) (?:not |already |also |no longer )?there\b(?! (?:a|an|any|no|is|are)\b)(?!.*\?)", "'exists', 'is missing'"),
    ("is what/where/how/why", r"\b(?:is|are|was|were|be) (?:what|where|how|why|when|whatever)\b(?!.*\?$)", "turn the sentence round"),
    ("which/that says so, as such", r"\b(?:says?|said) so\b|\b(?:is|are) (?:warned|told) of\b|\bwarns? of\b(?! (?:a|an|the) (?:impending|possible|potential)\b)", "say what is reported"),
    ("where/for/of that (pronoun that)", r"\bwhere that\b|\b(?:for|of|after|before|with|without|by|from|to|in|than|at|over|on) that[.,;:)]|\bthat that\b|\bthat (?:is|was) (?:that|what|where|of)\b", "name the noun"),
    ("one that/one where/the one before", r"\b(?:the one|the ones|one|ones) (?:before|that|which|where|whose|around|behind|beside|nearest|without|as)\b(?! (?:hand|time)\b)", "repeat the noun"),
    ("a x each / a byte a point", r"\ba (?:row|byte|bit|value|line|case|second|file|number|colour|color|texel|texture|page|test|point|column|process|thread|word|pixel) (?:each|an?(?= [a-z]+(?:[.,;:)]| and\b|$)))\b", "'one x per y'"),
    ("left out/left aside", r"\b(?:left|leaves?|leaving|be left|leave) (?:out|aside|them|it|open|over|to itself|as)\b", "'skipped', 'ignored', 'excluded'"),
    ("goes on/and on/to and fro", r"\b(?:goes|go|went|going|gone) on\b|\bon and on\b|\bto and fro\b|\bround and round\b|\bagain and again\b", "'continues', 'repeatedly'"),
    ("goes/comes/stands as generic verb", r"\b(?:goes|went|gone|stands?|stood) (?:for|in|to|by|through|out|over|into|with|around|there|where|aside|back|first|last|together|apart|away|at|as|up|along|home|straight|before|beside|behind|after|the)\b|\b(?:comes|came) (?:out|back|first|last|together|apart|through|home|at|to|before|behind|after|along|down to|up|into)\b", "use a precise verb: 'represents', 'enters', 'returns'"),
    ("has no memory/word/place", r"\b(?:has|have|had|with) no (?:memory|word|words|place|room|end|side|sides|name|size|length|number|order|axis|sight|matter|picture)\b", "'out of memory', 'has zero length'"),
    ("takes (= uses/costs/accepts)", r"\b(?:is|are|was|were|be|been) (?:taken|had|gone|let|put|met|looked|come|begun|got)\b(?! (?:into account|into consideration|care|place|away|over|offline|down|on|up|together)\b)", "'used', 'read', 'accepted', 'passed'"),
    ("gives (= returns/produces)", r"\b(?:gives|gave)\b", "'returns', 'produces', 'yields'"),
    ("lets ... through", r"\blets?\b(?: \w+){0,3}? through\b", "'transmits'"),
    ("many ... twice 'as' of size", r"\bas (?:far|wide|near|fine|coarse|thick|often|many|much|few|large|good|high|deep) as (?:one|there|it|they|that|those|can|is|are|what|the \w+ (?:is|are|has|have|goes?))\b", "use a number or 'up to'"),
    ("one sees/likes/would", r"\bone (?:sees|likes|wants|would|looks|asks|says)\b", "'you', or the passive"),
    ("nobody/nowhere/nor", r"\b(?:nobody|nowhere)\b|(?:[,;] nor|^nor) (?:does|do|is|are|that|has|have|can|where|in|by|of)\b", "'not', 'no thread', 'not anywhere'"),
    ("of two dimensions / of 16 bits", r"\bof (?:one|two|three|four|five|six|fewer|several|more|\d+|\d+ (?:and|or) \d+) (?:dimensions?|components?|bytes|bits|floats|channels)\b(?! (?:from|to|per))", "'two-dimensional', '16-bit', '3-component'"),
    ("texture/picture of floats", r"\b(?:textures?|pictures?|buffers?|framebuffers?|maps?|arrays?|images?) of (?:floats?|bytes|doubles)\b", "'floating-point texture'"),
    ("order of visibility, lines of sight", r"\border of (?:visibility|drawing)\b|\blines? of sight\b", "'visibility order', 'drawing order', 'view ray'"),
    ("by threads", r"\bby (?:threads|all threads|any thread|one thread|several threads|a thread|two threads)\b", "'in parallel', 'multithreaded'"),
    ("in the mean", r"\b(?:in the mean|in the whole|on the whole)\b", "'on average', 'at the center'"),
    ("to rounding / but for rounding", r"\b(?:but for|to|beyond|by|than|within|for) rounding\b(?! error| mode|-off)", "'error', 'up to rounding error'"),
    ("as it is/as they are", r"\bas (?:it|they) (?:is|are|was|were|came|comes?|stands?|lies?)(?=[.,;:)]|$| (?:and|in|on|at|by|for|to|with|without|where|of|there)\b)|\b(?:is|are|was|were|be) as (?:is|was|with|without|for|in|of|by|before|if)\b", "'unchanged'"),
    ("the last bit/same bytes", r"\bto the last (?:bit|byte|digit)\b|\bthe same bytes\b|\bbit for bit\b", "'bit-identical'"),
    ("by itself/of itself/at hand", r"\b(?:of|in) (?:itself|themselves)\b|\bat hand\b", "'automatically', 'separately'"),
    ("each once / each with", r"\beach (?:once|twice|of one|its own)\b|\b(?:once|twice) each\b", "'exactly once', 'one per'"),
    ("numbers of / counts of", r"\bthe (?:numbers of|bytes of|bytes that|seconds (?:that|of)|ways (?:of|to)|counts of)\b", "'number of', 'size in bytes', 'duration'"),
    ("is made (of/when/from)", r"\b(?:is|are|was|were|be|been) made (?:of|from|by|when|at|for|once|only|anew|up|as|in|with|out|to|that|here|there|where|again)\b(?! (?:sure|available|public|private))|\bmade (?:of|from) (?:what|those|that|its)\b", "'is built', 'is created'"),
    ("refuse / fault / obstacle", r"\b(?:refus(?:es?|ed|al|ing)|obstacles?|lacks)\b", "'reject', 'error', 'is missing'"),
    ("as without, without and with", r"\bwithout and with\b(?!out)|\b(?:as|than|the same|is|are|be) without\b(?! (?:the|a|an|any|all|other|respect|effect)\b)", "name the case: 'the same as when x is off'"),
    ("colour by/color by", r"\bto colou?r by\b|\bcolou?red by what\b", "'scalar used for coloring'"),
    ("times the time", r"\btimes the time\b|\b(?:half|a half|a quarter|a third|a tenth|\d+ %) (?:of )?the time of\b|\btimes as long as\b", "'takes 1.3 times as long', 'is 1.3x slower'"),
    ("said twice: clause, which clause", r",? (?:which|who) (?:it|they|one|he) (?:then|thus|so|again|itself|themselves)\b", "split the sentence"),
    ("archaic adverb", r"\b(?:merely|hardly|scarcely|therein|thereof|whereby|hereby|thither|amid|likewise|henceforth|forthwith|thrice|ere|lest)\b", "plain word: 'only', 'almost not', 'in it'"),
    ("a semicolon chain", r"(?:[^;(){}=<>\":*0-9]+; ){3,}[a-z]", "split into sentences or a list"),
]

WORDS = [
    ("picture", r"\bpictures?\b|\bpicture['’]s\b", "image, frame, rendering"),
    ("place (= position)", r"(?<!in )(?<!take )(?<!takes )(?<!took )(?<!taken )(?<!taking )(?<!in-)(?<!decimal )\bplaces?\b(?! (?:the|a|an|it|them|this|these|those|widget|in|on|at|holder)\b)", "position, location, slot, index"),
    ("share (= fraction)", r"\b(?:the|a|its|their|each|this|that|whose|what|which|small|large|as|by|of|equal) shares?\b", "fraction, proportion"),
    ("middle", r"(?<!in the )\bmiddles?\b(?! (?:mouse|button|click|man|ware|-click|drag))", "midpoint, center"),
    ("matter (= medium)", r"(?<!no )(?<!not )(?<!doesn't )(?<!does not )(?<!n't )\bmatter(?:['’]s)?\b(?! (?:of|what|how|where|whether|which|for|if|when|that)\b)(?=.*)(?<!subject matter)", "medium, participating medium, extinction"),
    ("beside (prep.)", r"\bbeside\b", "next to, in addition to, adjacent to"),
    ("beyond", r"\bbeyond\b(?! the scope)", "on the far side of, outside, past, more than"),
    ("whole (noun; whole cell)", r"\bthe wholes?(?=[.,;:)]| (?:is|has|does|are|was|of it|of them|and|where|in which)\b|$)|\bwhole cells?\b|\b(?:kept|passed on|passed|stay|stays|left|come out|taken|found|drawn) whole\b|\b(?:is|are|not) whole(?=[.,;:)]|$| (?:and|in|where|as|by|without)\b)|\bwholly\b", "entire, complete, interior (uncut) cells"),
    ("pane", r"\bpanes?\b", "translucent layer"),
    ("caster", r"(?<!shadow )(?<!ray )(?<!shadow-)\bcasters?\b", "shadow caster, occluder"),
    ("lane", r"(?<!SIMD )(?<!vector )(?<!simd )\blanes?\b", "SIMD lane"),
    ("kept", r"\bkept\b(?! (?:in sync|alive|up to date|for backward|as is))", "cached, retained, stored, preserved"),
    ("thin (verb)", r"\b(?:thins|thinned|thinning)\b", "subsample, decimate"),
    ("room/house (code)", r"\b(?:rooms?|houses?) (?:of|for|that|may|is|are|in|below|above|tests?|includes?)\b|\b(?:has|is|no|leaves?|have) room\b", "component; capacity"),
    ("wrong (noun)", r"\bwrong\b(?! (?:place|number|type|value|result|answer|order|direction|way|index|size|side|version|path|name|one|file|format|dimension|format|color|colors|position|argument|arguments)\b)", "error, invalid, mismatch"),
    ("way (= length, method)", r"\b(?:a|its|the|their|short|long|whole|free|each|every|both|other|same|all|of|no|such|farthest|longest) ways?\b(?! (?:to|of|that|in which|you|we|it|for|around|they|the|this|forward|data|as|which|back|things|too)\b)|\bways (?:of|in|to|through|that)\b", "distance, path, method"),
    ("apart", r"\b(?:are|is|be|or|goes?|come|drawn|volumes|boxes|pieces|lie|lies|meshes|blocks|moved) apart(?=[.,;:)]|$| (?:in|from each|and|where|or|by)\b)", "separate, disjoint"),
    ("alike", r"\balike\b", "the same way, identical"),
    ("aside", r"\baside\b(?! from)", "sideways; drop it"),
    ("peer (benchmark)", r"\bpeers?['’]?s?\b(?!-to-| to peer|.?review)", "baseline, reference implementation"),
    ("anyhow/at all/at once", r"\b(?:anyhow|as one likes|in one go|at one go|and so forth|in turn with)\b", "drop it, or be specific"),
    ("answer (= result)", r"\banswers?\b(?! (?:the|a|to|this|your|questions?)\b)", "result, value"),
    ("nearer", r"\bnearer\b", "closer"),
    ("goes/gone", r"\bgoes\b(?! (?:from|to|through|wrong|out of scope)\b)", "runs, extends, continues"),
    ("lies/stands/stays", r"\b(?:stays|stands|stood|lain)\b", "remains, is located, represents"),
    ("spare/serve/do (idiom)", r"\b(?:spares?|serves? for|does for|will do|do for|makes do|does without|do without|is of no)\b(?! (?:time|no))", "avoids, is used for"),
    ("ones (plural pronoun)", r"\b(?:new|larger|smaller|hard|soft|small|large|last|next|first|these|those|whose|unstructured|flat|thin|good|bad|same|former|outer|inner|dark|bright|earlier|later|thick) ones\b", "repeat the noun"),
    ("lamp/eye/ball", r"\b(?:lamps?|the eye (?:sees|is|goes|has)|eye sees|the eye['’]s|balls?)\b", "light, camera, sphere"),
    ("figures/words (report)", r"\b(?:in words|by words|words of|the words|has no word|in figures)\b", "text, label, token"),
    ("much/little/few (bare pronoun)", r"\b(?:by much|by little|of much|too few|too many|as little|as few|so few|so little|that much|not much|how many)\b(?=[.,;:)]|$)", "give the quantity"),
]

BRITISH = r"""\b(?:colour(?:s|ed|ing|less|maps?)?|uncoloured|greys?|greyscale|centres?|centred|centring
 |neighbours?|neighbouring|neighbourhoods?|behaviours?|favours?|favourite|honour(?:s|ed)?|metres?|millimetres?|kilometres?
 |fibres?|litres?|licen[c]e[sd]?|defence|offence|catalogues?|analogues?|dialogues?|modell(?:ed|ing|er)|labell(?:ed|ing)
 |travell(?:ed|ing|s)|cancell(?:ed|ing)|signall(?:ed|ing)|tunnell(?:ed|ing)|levell(?:ed|ing)|channell(?:ed|ing)
 |initialis\w*|normalis\w*|optimis(?:e|ed|es|ing|ation)|organis\w*|recognis\w*|visualis\w*|serialis\w*|synchronis\w*|discretis\w*
 |linearis\w*|parallelis\w*|regularis\w*|generalis\w*|specialis\w*|minimis\w*|maximis\w*|summaris\w*|parametris\w*|triangularis\w*
 |polaris\w*|analys(?:e|ed|es|ing)|artefacts?|programmes?|judgement|towards|afterwards|whilst|amongst|learnt|burnt|spelt
 |sceptic\w*|mould\w*|plough\w*|tyres?|discs?)\b"""
AMERICAN = r"""\b(?:colors?|colored|coloring|grays?|grayscale|centers?|centered|centering|neighbors?|neighboring|neighborhoods?|behaviors?
 |meters?|licenses?|licensed|catalogs?|modeled|modeling|labeled|labeling|traveled|canceled|initializ\w*|normaliz\w*|optimiz\w*
 |organiz\w*|recogniz\w*|visualiz\w*|serializ\w*|synchroniz\w*|discretiz\w*|lineariz\w*|paralleliz\w*|generaliz\w*|minimiz\w*|maximiz\w*
 |analyz\w*|artifacts?|toward|disks?)\b"""

# Components of identifiers, file names and XML names. A name is split at
# capitals and underscores; one hit per distinct name.
NAME_WORDS = {
    "matter": "Medium, Extinction", "pane": "Translucent", "panes": "Translucent", "caster": "ShadowCaster",
    "casters": "ShadowCasters, Occluders", "whole": "Interior, Entire", "wholes": "Interior", "beyond": "FarSide", "lane": "Simd",
    "lanes": "Simd", "kept": "Cached, Retained", "wish": "Request", "wishes": "Requests", "told": "Reported",
    "said": "Stated", "says": "Reports", "say": "Report", "tells": "Indicates", "ask": "Request", "asks": "Requests",
    "asked": "Requested", "asking": "Requesting", "news": "Changes", "wrong": "Error, Invalid", "picture": "Image, Frame", "pictures": "Images",
    "place": "Position, Location", "places": "Positions", "middle": "Midpoint, Center", "middles": "Midpoints, Centers",
    "share": "Fraction", "shares": "Fractions", "peer": "Baseline", "peers": "Baselines",
    "way": "Distance, Path", "ways": "Methods, Paths", "most": "Maximum", "least": "Minimum", "fewest": "Minimum",
    "elsewhere": "Other", "beside": "Near", "alone": "Only", "alike": "Equal", "answer": "Result", "answers": "Results", "lamp": "Light",
    "forget": "Clear, Reset", "forgets": "Clears", "lack": "Missing", "fault": "Error", "faults": "Errors", "obstacle": "Error",
    "sightline": "ViewRay", "apart": "Separate, Disjoint", "ball": "Sphere", "met": "Visited",
    "colour": "Color", "colours": "Colors", "centre": "Center", "centres": "Centers", "neighbour": "Neighbor",
    "neighbours": "Neighbors", "grey": "Gray", "disc": "Disk",
}
# Names in which these words are VTK's, OpenGL's or common usage.
NAME_ALLOW = re.compile(
    r"(?i)whole_?(?:extent|field)|simd_?lane|placewidget|place_?factor|placeholder|inplace|in_place|replace|mousemiddle|middle(button|mouse|click)"
    r"|least_?square|leastsig|mostsig|almost|raycaster|shadow_?casters?|spellcaster|oneway|two_?way|halfway|gateway|always"
    r"|ball_?pivot|trackball|chatroom|headroom|disc(ret|ard|onn|over|rim)|emplace|whatsthis|rightmost|leftmost|topmost|outermost|innermost|uppermost|lowermost"
    r"|owner|share_?dir|datarootdir|faultHandler|segfault|pagefault|broadcaster|forecaster|nothrow|default|lefthanded|righthanded"
    r"|^at_?(most|least)$|^most_common$|TakeSmartPointer|FlowObstacle|^place(in|points|light|corners|faces|planes|surfaces|sheet|handle)|_h$")
NAME_VERBS = re.compile(r"^(Take|Give|Tell|Ask|Say|Go|Know|Forget)(?=[A-Z])")
NAME_VERBS_ALLOW = re.compile(r"^(TakeScreenshot|TakeSnapshot|GoTo|GoForward|GoBack)")

# Sentences that contain one of these literals are not reported.
ALLOW = [
    "BSD 3-Clause",
]

# ---------------------------------------------------------------------------
# Extraction

Block = collections.namedtuple("Block", "path line kind text lines")


def list_files(root, paths):
    """Return the tracked files below root; without git, all files."""
    command = ["git", "-C", root, "ls-files", "-z", "--"] + list(paths)
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if done.returncode == 0 and done.stdout:
        return [name for name in done.stdout.decode("utf-8", "replace").split("\0") if name]
    found = []
    for start in paths or ["."]:
        start = os.path.join(root, start)
        if os.path.isfile(start):
            found.append(os.path.relpath(start, root))
        for directory, names, files in os.walk(start):
            names[:] = sorted(n for n in names if not n.startswith(".") and n not in SKIPPED_DIRECTORIES)
            found += [os.path.relpath(os.path.join(directory, f), root) for f in sorted(files)]
    return found


C_TOKEN = re.compile(
    r'''//[^\n]*|/\*.*?\*/|R"([^()\s]{0,16})\((.*?)\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+\'''', re.S)
MESSAGE_GAP = re.compile(r"\s*|[\s()]*(?:<<|\+)[\s\w()\->.:\[\]&*,?\"]{0,80}?(?:<<|\+)[\s()]*|\s*(?:<<|\+)\s*")


def read_c(path, text):
    """Yield comment and message blocks, then the code without them as a block of kind 'code'."""
    starts = [0] + [m.end() for m in re.finditer("\n", text)]

    def line_of(position):
        low, high = 0, len(starts)
        while high - low > 1:
            mid = (low + high) // 2
            low, high = (mid, high) if starts[mid] <= position else (low, mid)
        return low + 1

    code, blocks, last = [], [], 0
    for match in C_TOKEN.finditer(text):
        token, gap = match.group(0), text[last:match.start()]
        code.append(gap)
        line = line_of(match.start())
        previous = blocks[-1] if blocks else None
        if token.startswith("//"):
            body = re.sub(r"^//[/!]?<?[ \t]?", "", token)
            trailing = text[starts[line - 1]:match.start()].strip() != ""
            if previous and previous[1] == "line" and not trailing and not previous[4] and not gap.strip() and gap.count("\n") == 1:
                previous[2] += "\n" + body
                previous[3] += 1
            else:
                blocks.append([line, "line", body, 1, trailing])
        elif token.startswith("/*"):
            body = "\n".join(re.sub(r"^\s*\*?[*!]?[ \t]?", "", row) for row in token[2:-2].split("\n"))
            blocks.append([line, "block", body, token.count("\n") + 1, False])
        elif token[0] in '"R':
            body = match.group(2) if token[0] == "R" else token[1:-1]
            body = body.replace("\\n", " ").replace('\\"', '"')
            if previous and previous[1] == "message" and MESSAGE_GAP.fullmatch(gap):
                previous[2] += ("IDN" if re.search(r"\w", gap) else "") + body
            else:
                blocks.append([line, "message", body, 1, False])
            code.append(' "" ')
        else:
            code.append(" 0 ")
        last = match.end()
    code.append(text[last:])
    for line, kind, body, lines, _ in blocks:
        if kind == "message":
            if is_message(body):
                yield Block(path, line, "message", body, lines)
        elif not re.search(r"SPDX-License|Copyright|clang-format|NOLINT", body):
            rows = [row for row in body.split("\n") if row.strip()]
            if rows and not all(re.search(r"[;{}]\s*$|^\s*#", row) for row in rows):
                yield Block(path, line, "comment", body, lines)
    yield Block(path, 1, "code", re.sub(r"(?m)^\s*#\s*include.*$", "", " ".join(code)), 0)


def is_message(text):
    """Return whether a string literal reads like a sentence."""
    words = re.findall(r"[A-Za-z]{2,}", text)
    if len(words) < 4 or " " not in text.strip():
        return False
    if re.search(r"[{}]|;\s*$|\);|//|\bvoid\b|\bvec[234]\b|\bfloat\b|\buniform\b|<\w+|%\w", text):
        return False
    return sum(word.islower() for word in words) >= 0.6 * len(words)


def read_python(path, text):
    try:
        tokens = list(tokenize.generate_tokens(io.StringIO(text).readline))
    except (tokenize.TokenError, SyntaxError, IndentationError):
        return
    names, comment = [], None
    for token in tokens:
        if token.type == tokenize.COMMENT:
            body = token.string.lstrip("#").strip()
            if token.string.startswith("#!") or "SPDX" in body or "Copyright" in body or "pylint" in body:
                continue
            if comment and comment[2] == token.start[0] - 1:
                comment = (comment[0], comment[1] + "\n" + body, token.start[0])
            else:
                if comment:
                    yield Block(path, comment[0], "comment", comment[1], 1)
                comment = (token.start[0], body, token.start[0])
        elif token.type == tokenize.STRING:
            try:
                value = ast.literal_eval(token.string)
            except (ValueError, SyntaxError):
                continue
            if isinstance(value, str) and (is_message(value) or token.string.lstrip("rRuUbB").startswith(('"""', "'''")) and "{" not in value):
                yield Block(path, token.start[0], "comment" if "\n" in value else "message", value, value.count("\n") + 1)
        elif token.type == tokenize.NAME:
            names.append(token.string)
    if comment:
        yield Block(path, comment[0], "comment", comment[1], 1)
    yield Block(path, 1, "code", " ".join(names), 0)


def read_hash_comments(path, text):
    """Comments of shell and CMake files."""
    first, rows = 0, []
    for number, row in enumerate(text.split("\n") + [""], 1):
        match = re.match(r"\s*#(?!!)[ \t]?(.*)", row)
        if match:
            if not rows:
                first = number
            rows.append(match.group(1))
        elif rows:
            body = "\n".join(rows)
            if "SPDX" not in body and "Copyright" not in body:
                yield Block(path, first, "comment", body, len(rows))
            rows = []


XML_TEXT = re.compile(
    r'(?P<help>(?:short_help|long_help)\s*=\s*"(?P<a>[^"]*)")|<Documentation[^>]*>(?P<b>[^<]*)<|<!--(?P<c>.*?)-->'
    r'|<Text[^>]*>(?P<d>[^<]*)<|\b(?:label|panel_visibility_label)\s*=\s*"(?P<e>[^"]*)"|<(?:Property\w*|\w*Property|\w*Proxy)\b[^>]*?\bname\s*=\s*"(?P<f>[^"]*)"', re.S)


def read_xml(path, text):
    for match in XML_TEXT.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        if match.group("e"):
            yield Block(path, line, "label", match.group("e"), 1)
        elif match.group("f"):
            yield Block(path, line, "code", match.group("f"), 0)
        else:
            body = match.group("a") or match.group("b") or match.group("c") or match.group("d") or ""
            if body.strip():
                yield Block(path, line, "tooltip", body, body.count("\n") + 1)


def read_markdown(path, text):
    """Paragraphs, headings and table cells; no code, HTML comments or link targets."""
    blank = lambda match: "\n" * match.group(0).count("\n")
    text = re.sub(r"(?ms)^[ \t]*(```|~~~).*?^[ \t]*\1[^\n]*$", blank, text)
    text = re.sub(r"(?s)<!--.*?-->", blank, text)
    text = re.sub(r"(?s)<(script|style|svg)\b.*?</\1>", blank, text)
    text = re.sub(r"!?\[([^\]]*)\]\([^)\s]*(?:\s\"[^\"]*\")?\)", r"\1", text)
    text = re.sub(r"<[^>\n]+>", " ", text)
    paragraph, first = [], 0
    for number, row in enumerate(text.split("\n") + [""], 1):
        stripped = row.strip()
        item = re.match(r"\s*(?:[-*+]|\d+\.)\s+(.*)", row)
        special = not stripped or stripped.startswith(("#", "|", ">")) or item or re.match(r"^ {4,}\S", row) and not paragraph
        if special and paragraph:
            yield Block(path, first, "text", "\n".join(paragraph), len(paragraph))
            paragraph = []
        if not stripped:
            continue
        if stripped.startswith("#"):
            yield Block(path, number, "heading", stripped.lstrip("# "), 1)
        elif stripped.startswith("|"):
            for cell in stripped.strip("|").split("|"):
                if len(re.findall(r"[A-Za-z]{2,}", cell)) >= 3:
                    yield Block(path, number, "cell", cell.strip(), 1)
        elif item:
            paragraph, first = [item.group(1)], number
        elif re.match(r"^ {4,}\S", row) and not paragraph:
            continue
        else:
            if not paragraph:
                first = number
            paragraph.append(stripped.lstrip("> "))


def read_file(root, path):
    try:
        with open(os.path.join(root, path), encoding="utf-8", errors="replace") as stream:
            text = stream.read()
    except OSError:
        return
    name, suffix = os.path.basename(path), os.path.splitext(path)[1].lower()
    if suffix in C_SUFFIXES:
        yield from read_c(path, text)
    elif suffix == ".py" or not suffix and re.match(r"#!.*python", text):
        yield from read_python(path, text)
    elif suffix in (".sh", ".cmake") or name == "CMakeLists.txt" or not suffix and text.startswith("#!"):
        yield from read_hash_comments(path, text)
    elif suffix == ".xml":
        yield from read_xml(path, text)
    elif suffix == ".md":
        yield from read_markdown(path, text)


# ---------------------------------------------------------------------------
# Sentences


def sentences(block):
    """Yield (line, sentence) of a block. Code, doxygen commands and links are removed."""
    text = block.text
    text = re.sub(r"(?s)[@\\]code\b.*?[@\\]endcode|[@\\]verbatim\b.*?[@\\]endverbatim|\\f[$\[].*?\\f[$\]]", " IDN ", text)
    text = re.sub(r"(?m)^\s*[@\\](?:class|struct|file|sa|see|name|defgroup|ingroup|addtogroup|author|date|version)\b.*$", "", text)
    text = re.sub(r"(?m)[@\\]returns?\b", "\n\nReturns", text)
    text = re.sub(r"(?m)[@\\](?:brief|short|details|note|warning|pre|post|todo|par)\b", "\n\n", text)
    text = re.sub(r"(?m)[@\\]t?param(?:\[\w*(?:,\w*)?\])?\s+\S+", "\n\n", text)
    text = re.sub(r"[@\\](?:a|c|p|e|em|ref|b|cite)\s+\S+?(?=[\s,.;:)]|$)", "IDN", text)
    text = re.sub(r"[@\\][{}]|[@\\]\w+\b", " ", text)
    text = re.sub(r"``?[^`\n]+``?", "IDN", text)
    text = re.sub(r"https?://\S+", "IDN", text)
    offset, line = 0, block.line
    for paragraph in re.split(r"(\n\s*\n|\n\s*(?=(?:[-*+]|\d+[.)])\s))", text):
        start = block.line + text.count("\n", 0, offset)
        offset += len(paragraph)
        flat = re.sub(r"^\s*(?:[-*+]|\d+[.)])\s+", "", paragraph)
        flat = re.sub(r"\s+", " ", flat).strip()
        if not re.search(r"[A-Za-z]{2}", flat):
            continue
        parts = re.split(r"(?<=[.!?])[\"')\]]?\s+(?=[A-Z\"'(\\@`0-9*])", flat)
        merged = []
        for part in parts:
            if merged and re.search(r"\b(?:e\.g|i\.e|vs|Fig|fig|al|resp|cf|approx|No|St|Dr|[A-Z])\.$", merged[-1]):
                merged[-1] += " " + part
            else:
                merged.append(part)
        consumed = 0
        for part in merged:
            yield start, part.strip()
            consumed += len(part)


def is_full_sentence(kind, sentence, words):
    """Return whether the shape patterns apply: not to labels, cells and fragments of messages."""
    if kind in ("cell", "heading", "label") or words < 3:
        return False
    return kind != "message" or sentence[:1].isupper()


WORD = re.compile(r"[A-Za-z][A-Za-z'’-]*")


def count_words(sentence):
    return len([w for w in WORD.findall(sentence) if w != "IDN"])


# ---------------------------------------------------------------------------
# Matching


def compile_patterns():
    flags = re.I
    table = []
    for group, entries in (("shape", SHAPES), ("phrase", PHRASES), ("word", WORDS)):
        for name, expression, hint, *path in entries:
            path = re.compile(path[0]) if path else None
            table.append((group, name, re.compile(expression, flags), hint, path))
    table.append(("spelling", "British spelling", re.compile(BRITISH, re.I | re.X), "American spelling, as VTK", None))
    return table


def split_name(name):
    return [part.lower() for part in re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+", name)]


class Report:
    def __init__(self):
        self.words = 0
        self.count = collections.Counter()      # hits by pattern
        self.hints = {}
        self.examples = collections.defaultdict(list)
        self.hits = 0                           # hits for the score, overlaps counted once
        self.by_group = collections.Counter()
        self.directory_words = collections.Counter()
        self.directory_hits = collections.Counter()
        self.american = 0
        self.british = 0
        self.readme_words = 0

    def add(self, name, hint, path, line, text, group, scored=True):
        self.count[name] += 1
        self.hints[name] = hint
        self.examples[name].append((path, line, text))
        if scored:
            self.hits += 1
            self.by_group[group] += 1
            self.directory_hits[directory_of(path)] += 1

    def score(self):
        return 1000.0 * self.hits / max(self.words, 1)


def directory_of(path):
    parts = path.replace("\\", "/").split("/")[:-1]
    return "/".join(parts[:2]) or "."


def excerpt(sentence, start, end):
    left, right = max(0, start - 45), min(len(sentence), end + 45)
    return ("..." if left else "") + sentence[left:right] + ("..." if right < len(sentence) else "")


def scan(root, paths):
    patterns = compile_patterns()
    american = re.compile(AMERICAN, re.I | re.X)
    british = re.compile(BRITISH, re.I | re.X)
    report = Report()
    names = {}
    for path in list_files(root, paths):
        parts = path.split("/")
        if parts[-1] in SKIPPED_FILES or any(part in SKIPPED_DIRECTORIES for part in parts[:-1]):
            continue
        if os.path.splitext(path)[1].lower() in C_SUFFIXES + (".py",):
            names.setdefault(os.path.splitext(os.path.basename(path))[0], (path, 1))
        for block in read_file(root, path):
            if block.kind == "code":
                for name in set(re.findall(r"\b[A-Za-z_]\w*", block.text)):
                    names.setdefault(name, (path, block.line))
                continue
            if block.kind == "comment" and block.lines > MAX_CLASS_COMMENT_LINES and re.search(r"[@\\]class|[@\\]brief", block.text):
                report.add("class comment > %d lines" % MAX_CLASS_COMMENT_LINES, "move the method to Documentation/methods",
                           path, block.line, "%d lines" % block.lines, "size")
            for line, sentence in sentences(block):
                if any(literal in sentence for literal in ALLOW):
                    continue
                words = count_words(sentence)
                report.words += words
                report.directory_words[directory_of(path)] += words
                report.american += len(american.findall(sentence))
                report.british += len(british.findall(sentence))
                if path == "README.md":
                    report.readme_words += words
                if block.kind not in ("cell", "heading", "label") and words > MAX_SENTENCE_WORDS:
                    report.add("sentence > %d words" % MAX_SENTENCE_WORDS, "one idea a sentence",
                               path, line, "%d words: %s..." % (words, sentence[:80]), "size")
                taken = []
                for group, name, expression, hint, only in patterns:
                    if only and not only.search(path):
                        continue
                    if group == "shape" and not is_full_sentence(block.kind, sentence, words):
                        continue
                    for match in expression.finditer(sentence):
                        if match.start() == match.end():
                            continue
                        overlaps = any(match.start() < end and start < match.end() for start, end in taken)
                        if overlaps and group != "spelling":
                            continue
                        taken.append((match.start(), match.end()))
                        report.add(name, hint, path, line, excerpt(sentence, match.start(), match.end()), group)
    for name, (path, line) in sorted(names.items()):
        check_name(report, name, path, line)
    if report.readme_words > MAX_README_WORDS:
        report.add("README > %d words" % MAX_README_WORDS, "move detail to the guide", "README.md", 1,
                   "%d words" % report.readme_words, "size")
    return report


def check_name(report, name, path, line):
    if NAME_ALLOW.search(name):
        return
    for part in split_name(name):
        if part in NAME_WORDS:
            report.add("name: " + part, NAME_WORDS[part], path, line, name, "name")
            return
    if NAME_VERBS.match(name) and not NAME_VERBS_ALLOW.match(name):
        report.add("name: " + NAME_VERBS.match(name).group(1) + "...()", "Get, Release, Request, Advance, Reset", path, line, name, "name")


# ---------------------------------------------------------------------------
# Output


def spread(examples, number=3):
    """Return a few examples from different files."""
    chosen, seen = [], set()
    step = max(1, len(examples) // number)
    for example in examples[::step] + examples:
        if example[0] not in seen and len(chosen) < number:
            seen.add(example[0])
            chosen.append(example)
    return chosen


def print_report(report, top):
    rows = report.count.most_common(top)
    print("%-44s %6s  %s" % ("pattern", "hits", "suggestion"))
    for name, count in rows:
        print("%-44s %6d  %s" % (name, count, report.hints[name]))
        for path, line, text in spread(report.examples[name]):
            print("    %s:%d: %s" % (path, line, text))
    print()
    print("%-44s %8s %8s %8s" % ("directory", "words", "hits", "score"))
    for directory, words in sorted(report.directory_words.items()):
        hits = report.directory_hits[directory]
        print("%-44s %8d %8d %8.1f" % (directory, words, hits, 1000.0 * hits / max(words, 1)))
    print()
    print("words of prose %d, README %d; spelling: %d British, %d American" % (
        report.words, report.readme_words, report.british, report.american))
    print("hits %d: %s" % (report.hits, ", ".join("%s %d" % item for item in report.by_group.most_common())))
    print("score %.1f hits per 1,000 words" % report.score())


def main(arguments):
    top, root, paths, show, only_score = None, ".", [], None, False
    position = 0
    while position < len(arguments):
        argument = arguments[position]
        if argument in ("-h", "--help"):
            print(__doc__)
            return
        if argument == "--score":
            only_score = True
        elif argument in ("--top", "--show", "--root") and position + 1 < len(arguments):
            position += 1
            if argument == "--top":
                top = int(arguments[position]) if arguments[position].isdigit() else None
            elif argument == "--show":
                show = arguments[position]
            else:
                root = arguments[position]
        else:
            paths.append(argument)
        position += 1
    report = scan(root, paths)
    if show is not None:
        for name in report.count:
            if show.lower() in name.lower():
                for path, line, text in report.examples[name]:
                    print("%s:%d: [%s] %s" % (path, line, name, text))
    elif only_score:
        print("%.1f" % report.score())
    else:
        print_report(report, top)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except BrokenPipeError:
        sys.stderr.close()
