# SPDX-License-Identifier: LGPL-2.1-or-later

"""The ways in which a parameter file is spoilt.

Each takes a random generator and a Case, changes the case and returns one line that
says what was done, or None if there is nothing in the case that it could change.
"""

import re

from case_files import SET, SUBSECTION, choose
from entries import NAMED, NUMBER, TABLE, kind_of
from units import dimension, parse_unit

UNITS = """
m mm cm um km in ft kg g mg t lb s ms min h rad deg mrad turn N kN mN lbf Pa kPa MPa GPa
bar psi J kJ W kW Hz kHz rpm rad/s deg/s rad/min m/s mm/s km/h m/s^2 mm/s^2 g/cm^3 kg/m^3
t/m^3 lb/in^3 kg/m^2 kg~m^2 kg~mm^2 g~cm^2 kg~m kg~m^2/s N/m N/mm kN/m lbf/in N/m^2 N/m^3
N/mm^3 kN/m^3 N~m N~mm lbf~in N~m/rad N~m/deg N~m~rad N~s/m N~s/mm N~m~s N~m~s/rad s/m
m^-1 mm^-1 m^2 mm^2 m^3 mm^3 cm^3 Pa^-1 MPa^-1 GPa^-1 mm^3/(N~m) m^3/(N~m) mm^3/N/m
mm^3/N~m um^2/N K K/s A V rad^2 m~rad kg~rad N/m/rad 1/rad 1/s 1/m 1/kg m/N rad~s s^2 s^-1
""".split()
UNITS = [unit.replace("~", " ") for unit in UNITS]

#: Texts behind a number that are no unit, or one that nobody means.
NO_UNITS = """
furlongs mmm M% % ppm dB lg(re~1~mm) lg(re~1~kg) ln(re~1~Pa) mm@3 mm~@~5 m~from~3
s~since~2000-01-01 degC ° ' '' " "5~mm '30~deg mm' µm μm mm² mm³ m·s kg·m² N·m Nm mmm^3
mm^99 mm^-99 mm^0 m^1.5 mm^ mm/ /mm //mm mm//s (mm mm) () ((mm)) mm;kg mm,~mm mm=1
kilogram~metre mol cd sr Bq 1 2 10~mm 1e3~mm 1e300~mm 0~mm e3~mm E3~mm x10^3~mm *10^3~mm
rad.s-1 s-1 m2 m-1 mm3/N/m N.m N*m N**m kg-m2 Mm mM MM KG RPM Rpm gpa GPA Gpa MPA mpa
""".split()
NO_UNITS = [unit.replace("~", " ") for unit in NO_UNITS]

NUMBERS = """
0 -0 +0 0.0 -1 1e-300 -1e-300 1e300 1e308 -1e308 1.8e308 1e-308 4.9e-324 1e400 -1e400
1e-400 1e9 1e-9 1e15 -1e15 1e-15 1e30 1e-30 1e99 nan NaN -nan nan(123) inf -inf Infinity
infinity 0x10 0x1p3 1e 1e+ 1e+- --1 +-1 - + . .5 5. 1.5.5 1,5 0,5 1,000 1.000.000
1'000 1"000 1_000 1`000 1°000 1~000 1e5.5 1/2 2*3 (1) 1e-5-3 1d3 1f 1u 1L 01 1e0003 ١ ½ ∞
−1 1–2 1e999999999999999999999 1e-999999999999999999999 999999999999999999999999999999
0.000000000000000000000000000000000000000000000001 1:30 1;2 $1 one
""".split()
NUMBERS = [number.replace("~", " ") for number in NUMBERS]

INTEGERS = """
0 1 2 3 7 8 9 -1 1.5 1e3 1. 999999999 4294967295 4294967296 99999999999999999999 100000
10000 9999 0x10 +5 5- five 1,000 1'000 10~000 ~ nan inf ١٢ 1_000 007
""".split()
INTEGERS = [number.replace("~", " ") for number in INTEGERS]

EXPRESSIONS = """
0,5*t t,1 (0,5)*t 1,2,3 sin(2*pi*t),0 0.5*t; 1/0 0/0 1/t 1/(t-0.3) log(t) log(0) sqrt(-1)
sqrt(t-1) t^0.5 (-1)^t t^1e9 exp(1e9*t) exp(exp(exp(9*t))) 1e400 1e400*t nan inf rand()
rand_seed(1) floor(10*t) int(t) rint(t) sign(sin(6*t)) abs(sin(6*t)) tan(t) tan(2*pi*t)
if(t<0.1,0,1) if(t<0.1,t,1) if(t<, if(t<0.1) if() sin( sin) sin() sin(t,t) foo(t) x y p v s
t~t 2t 2~t t2 t' t=5 t==5 a=5 a:=5 t&&1 !t t?1:2 t?1 ((((t)))) ((t) "t" 't' t% t! t++ --t
+-+t pi PI Pi e _pi _e t*1e308*10 max(t) max() max(t,0.5) min(1,2,3) sum(1,2) atan2(t,1)
erfc(t) pow(t,2) fmod(t,1) t^^2 t**2 sin(t)cos(t) sin(1e18*t) sin(1e6*t) 1e-300*t -1 0 1e300
sin(2*pi*t)*1e30 t\\ {t} [t] t@1 t#1 ∫t τ × t×2 2·t 1e 1e+ .t ,t t, , ; ( ) ~ * /
if(if(if(t,t,t),t,t),t,t) cos(t cot(t) sec(t) csc(t) acos(2) asin(t+1) atanh(t) sinh(999*t)
(p/1e6)^0.5 p-1e6 -p v/0 s^-1 log(p) exp(p) 1/(s-s) p,v if(p<1e6,1,2) p^1e3
""".split()
EXPRESSIONS = [text.replace("~", " ") for text in EXPRESSIONS]

NAMES = """
ground crank follower bodies drivers duty_cycle history.csv summary.json .. . / con a/b a.b
a~b Ä ä名 ~ - + _ 0 nan ground.O crank.A crank. .A crank..A crank.A.B crank.Z CRANK.A
ground.ground slider.B %s %n%n%n $HOME `id` \\ ' " a;b a:b {} * ?
""".split()
NAMES = [name.replace("~", " ") for name in NAMES] + ["a" * 300, "x" * 100000]

WORDS = """
automatic none dynamic kinematic clearance ideal impact Hertz Flores yes no true false 0 1
revolute rigid massless~link HERTZ hertz Hertz~ spring-damper spring~damper static static~
""".split()
WORDS = [word.replace("~", " ") for word in WORDS] + ["static equilibrium", "y" * 5000]

INCLUDED = """
MAIN ./MAIN ../MAIN missing.prm . .. / /dev/null /dev/zero /dev/stdin /dev/full /etc/passwd
/proc/self/mem /proc/self/environ /proc/self/exe ~ a~b.prm "MAIN" 'MAIN' MAIN/ MAIN/x
http://localhost/x.prm *.prm -
""".split()

CONTROL = ["\x1b[31m", "\x1b]0;title\x07", "\x00", "\x07", "\r", "\x08\x08\x08", "\x7f",
           "\x9b31m", "\u202e", "\u200b", "\xa0", "\ufeff", "\udcff", "\udc80\udc80",
           "\x0b", "\x0c", "\x1a", "\x04"]  # fmt: skip


def is_quantity(kind):
    return kind not in ("text", "word", "name", "names", "integer", "expression", "1")


def is_dimensional(kind):
    return is_quantity(kind) and kind != "markers" and not kind.startswith("point")


def is_number(kind):
    return is_quantity(kind) or kind == "1"


def short(text):
    return text if len(text) < 60 else f"{text[:40]}... ({len(text)} characters)"


def change(case, entry, value):
    """Sets the value and says so."""
    case.set_value(entry, value)
    place = "/".join([*entry[2], entry[3]])
    return f"{place}: {short(repr(entry[4]))} -> {short(repr(value))}"


def one_number(rng, text):
    """A match of one of the numbers of a value that have a unit behind them."""
    found = list(re.finditer(NUMBER.pattern + r"(?=\s|$|,)", text))
    return rng.choice(found) if found else None


def replace_match(text, match, value):
    return text[: match.start()] + value + text[match.end() :]


def one_unit(rng, text):
    found = list(re.finditer(r"(?<=\d\s)[^,;]+", text))
    return rng.choice(found) if found else None


def other_unit(rng, case):
    entry = choose(rng, case.entries(), is_quantity)
    unit = entry and one_unit(rng, entry[4])
    return unit and change(
        case, entry, replace_match(entry[4], unit, rng.choice(UNITS))
    )


def no_unit(rng, case):
    entry = choose(rng, case.entries(), is_quantity)
    unit = entry and one_unit(rng, entry[4])
    if not unit:
        return None
    return change(case, entry, replace_match(entry[4], unit, rng.choice(NO_UNITS)))


def spoilt_unit(rng, case):
    """Its reciprocal, another power, one factor more, one letter other."""
    entry = choose(rng, case.entries(), is_quantity)
    unit = entry and one_unit(rng, entry[4])
    if not unit:
        return None
    text = unit.group()
    place = rng.randrange(len(text))
    spoilt = rng.choice(
        [
            f"1/({text})",
            f"({text})^-1",
            f"{text}^-1",
            f"({text})^2",
            f"({text})^0",
            f"({text})^-2",
            f"{text} rad",
            f"{text}/rad",
            f"{text} m",
            f"{text}/s",
            f"{text} {text}",
            f"{text}/{text}",
            f"1e200 1e200 {text}",
            f"0 {text}",
            f"2 {text}",
            f"lg(re 1 {text})",
            f"{text} @ 7",
            text[:place] + rng.choice("mkNsgr/ ^2.*-") + text[place:],
            text[:place] + text[place + 1 :],
            text.upper(),
            text[::-1],
            "lg(re " * 60 + "1 " + text + ")" * 60,
            "(" * 99 + text + ")" * 99,
            " ".join([text] * 300),
        ]
    )
    return change(case, entry, replace_match(entry[4], unit, spoilt))


def other_number(rng, case):
    entry = choose(rng, case.entries(), is_number)
    number = entry and one_number(rng, entry[4])
    if not number:
        return None
    return change(case, entry, replace_match(entry[4], number, rng.choice(NUMBERS)))


def scaled_number(rng, case):
    """A number that can be read, of another size or sign, or zero."""
    entry = choose(rng, case.entries(), is_number)
    number = entry and one_number(rng, entry[4])
    if not number:
        return None
    value = float(number.group()) or 1.0
    factor = rng.choice([0, -1, 2, 0.5, 10 ** rng.uniform(-14, 14), 1e-300, 1e300])
    scaled = f"{value * factor:.6g}"
    return change(case, entry, replace_match(entry[4], number, scaled))


def other_integer(rng, case):
    entry = choose(rng, case.entries(), lambda kind: kind == "integer")
    return entry and change(case, entry, rng.choice(INTEGERS))


def other_expression(rng, case):
    entry = choose(rng, case.entries(), lambda kind: kind == "expression")
    text = rng.choice(EXPRESSIONS + ["(" * 20000 + "t" + ")" * 20000, "t+" * 30000 + "t"])
    return entry and change(case, entry, text)


def new_function(rng, case):
    """A force, a driver or a coefficient of wear that follows an expression."""
    text = rng.choice(EXPRESSIONS)
    entries = case.entries()
    bodies = [e[4].split(",")[0] for e in entries if e[3] == "Bodies"]
    drivers = [e[4].split(",")[0] for e in entries if e[3] == "Drivers"]
    bushings = [e[4].split(",")[0] for e in entries if e[3] == "Bushings"]
    lines = case.lines[case.main]
    kind = rng.randrange(3)
    if kind == 0 and drivers:
        lines += [
            f"subsection Driver {drivers[0]}",
            f"set Angle amplitude = {rng.choice(['5 deg', '1e-3 rad', '90 deg'])}",
            f"set Time function = {text}",
            "end",
        ]
    elif kind == 1 and bushings:
        pin = rng.choice(["W", "Pin w"])
        lines += [
            f"subsection Bushing {bushings[0]}",
            f"set {pin}ear coefficient factor = {text}",
            "end",
        ]
    elif bodies:
        lines += [
            "set Torques = extra",
            "subsection Torque extra",
            f"set Body = {bodies[0]}",
            f"set Torque = {rng.choice(['1 N m', '1e-3 N m', '1e9 N m'])}",
            f"set Time function = {text}",
            "end",
        ]
    else:
        return None
    return f"new function {short(text)}"


def other_name(rng, case):
    entry = choose(rng, case.entries(), lambda kind: kind == "name")
    if not entry:
        return None
    others = [e[4] for e in case.entries() if e[5] == "name"]
    return change(case, entry, rng.choice(NAMES + others * 4))


def other_list(rng, case):
    entry = choose(rng, case.entries(), lambda kind: kind == "names")
    if not entry:
        return None
    names = [name.strip() for name in entry[4].split(",")]
    place = rng.randrange(len(names))
    kind = rng.randrange(6)
    if kind == 0:
        del names[place]
    elif kind == 1:
        names.insert(place, rng.choice(NAMES))
    elif kind == 2:
        names.append(names[place])
    elif kind == 3:
        names[place] = rng.choice(NAMES)
    elif kind == 4:
        rng.shuffle(names)
    else:
        names = [f"n{i}" for i in range(rng.choice([100, 10000]))]
    return change(case, entry, rng.choice([", ", ",", "; ", " "]).join(names))


def other_word(rng, case, words):
    entry = choose(rng, case.entries(), lambda kind: kind == "word")
    if not entry:
        return None
    own = words.get(entry[3], [])
    every = [word for several in words.values() for word in several]
    return change(case, entry, rng.choice(own * 3 + every[:30] + WORDS + [entry[4][:-1]]))


def any_value(rng, kind, words, name):
    """A value for an entry of a kind that the file need not have had."""
    if kind == "word":
        return rng.choice(words.get(name, []) + ["automatic"])
    if kind == "integer":
        return rng.choice(INTEGERS)
    if kind == "expression":
        return rng.choice(EXPRESSIONS)
    if kind in ("name", "names"):
        return rng.choice(NAMES)
    if kind == "text":
        return rng.choice(NAMES + CONTROL + ["/dev/null", "/dev/zero", ".."])
    number = rng.choice(["0", "-1", "1", "0.5", "1e-3", "1e3", "1e-9", "1e9", "1e300"])
    if kind == "1":
        return number
    wanted = "m" if kind == "markers" else kind.split("point ")[-1]
    right = [unit for unit in UNITS if parse_unit(unit)[1] == dimension(wanted)]
    unit = rng.choice(right * 5 + UNITS)
    if kind == "markers":
        return f"A: {number} {unit}, 0 m"
    return f"{number} {unit}" + (f", 1 {unit}" if kind.startswith("point") else "")


def new_entry(rng, case, words):
    """An entry more: of what can be said at that place."""
    blocks = case.blocks()
    if not blocks:
        return None
    path, first, last = rng.choice(blocks)
    section = SUBSECTION.fullmatch(case.lines[path][first].split("#")[0]).group(1)
    kind_of_section = next(
        (named for named in NAMED if section.startswith(named + " ")), section
    )
    table = TABLE.get(kind_of_section) or TABLE.get("Bushing/" + kind_of_section)
    if not table:
        return None
    name = rng.choice(sorted(table))
    value = any_value(rng, table[name], words, name)
    case.lines[path].insert(last, f"  set {name} = {value}")
    return f"{section}/{name} = {short(repr(value))} added"


def deleted_line(rng, case):
    path = rng.choice(sorted(case.lines))
    number = rng.randrange(len(case.lines[path]))
    return f"'{short(case.lines[path].pop(number))}' deleted"


def doubled_line(rng, case):
    path = rng.choice(sorted(case.lines))
    lines = case.lines[path]
    number = rng.randrange(len(lines))
    lines.insert(rng.randrange(len(lines) + 1), lines[number])
    return f"'{short(lines[number])}' once more"


def moved_line(rng, case):
    path = rng.choice(sorted(case.lines))
    lines = case.lines[path]
    line = lines.pop(rng.randrange(len(lines)))
    lines.insert(rng.randrange(len(lines) + 1), line)
    return f"'{short(line)}' moved"


def swapped_values(rng, case):
    entries = [entry for entry in case.entries() if entry[5]]
    if len(entries) < 2:
        return None
    alike = rng.random() < 0.6
    first = rng.choice(entries)
    second = rng.choice([e for e in entries if not alike or e[5] == first[5]])
    case.set_value(first, second[4])
    case.set_value(second, first[4])
    return f"{first[3]} and {second[3]} exchanged"


def renamed(rng, case):
    """An entry or a subsection with another name."""
    path = rng.choice(sorted(case.lines))
    lines = case.lines[path]
    places = [
        (number, match)
        for number, line in enumerate(lines)
        for match in [
            SET.fullmatch(line) or re.fullmatch(r"(\s*subsection\s+)(.*)()()", line)
        ]
        if match
    ]
    if not places:
        return None
    number, match = rng.choice(places)
    name = match.group(2)
    place = rng.randrange(len(name) + 1)
    other = rng.choice(
        [
            name[:place] + name[place + 1 :],
            name[:place] + rng.choice("aeX/_ =#") + name[place:],
            name.upper(),
            name.lower(),
            name.split()[-1],
            "",
            name * 200,
            rng.choice(NAMES),
            name.replace(" ", "  "),
            rng.choice(sorted(TABLE["Joint"])),
            rng.choice(CONTROL) + name,
        ]
    )
    lines[number] = match.group(1) + other + match.group(3) + match.group(4)
    return f"'{short(name)}' renamed to {short(repr(other))}"


def spoilt_block(rng, case):
    """A subsection deleted, doubled, in another, or with one 'end' too few."""
    blocks = case.blocks()
    if not blocks:
        return None
    path, first, last = rng.choice(blocks)
    lines = case.lines[path]
    block = lines[first : last + 1]
    name = block[0].strip()
    kind = rng.randrange(6)
    if kind == 0:
        del lines[first : last + 1]
        return f"{name} deleted"
    if kind == 1:
        place = rng.randrange(len(lines) + 1)
        lines[place:place] = block
        return f"{name} once more"
    if kind == 2:
        del lines[last]
        return f"{name} without its 'end'"
    if kind == 3:
        lines.insert(rng.randrange(len(lines) + 1), "end")
        return "an 'end' more"
    if kind == 4:
        depth = rng.choice([1, 10, 3000])
        lines[first:first] = ["subsection deep"] * depth
        lines.extend(["end"] * depth)
        return f"{name} in {depth} subsections"
    lines.insert(rng.randrange(len(lines) + 1), "subsection " + rng.choice(NAMES))
    return "a 'subsection' more"


def swapped_bodies(rng, case):
    """Two bodies change their places in all references."""
    entries = [entry for entry in case.entries() if entry[3] == "Bodies"]
    names = [name.strip() for entry in entries for name in entry[4].split(",")]
    if len(names) < 2:
        return None
    first, second = rng.sample(names + ["ground"], 2)
    for entry in [e for e in case.entries() if e[5] == "name"]:
        exchange = {first: second, second: first}
        body, dot, marker = entry[4].partition(".")
        case.set_value(entry, exchange.get(body, body) + dot + marker)
    return f"{first} and {second} exchanged"


def random_bytes(rng, case):
    path = rng.choice(sorted(case.lines))
    lines = case.lines[path]
    number = rng.randrange(len(lines))
    line = lines[number]
    for _ in range(rng.choice([1, 1, 2, 5, 20])):
        place = rng.randrange(len(line) + 1)
        code = rng.randrange(256)
        character = chr(code) if code < 128 else chr(0xDC00 + code)
        keep = rng.randrange(2)
        line = line[:place] + character + line[place + keep :]
    lines[number] = line
    return f"random bytes: {short(repr(line))}"


def control_characters(rng, case):
    entry = choose(rng, case.entries(), lambda kind: True)
    if not entry:
        return None
    place = rng.randrange(len(entry[4]) + 1)
    return change(
        case, entry, entry[4][:place] + rng.choice(CONTROL) + entry[4][place:]
    )


def long_value(rng, case):
    entry = choose(rng, case.entries(), lambda kind: True)
    if not entry:
        return None
    piece = rng.choice(["9", "a", " x", ", 1 mm", "; A: 0 m, 0 m", "%s", "é", "(", "1e", "-"])
    return change(case, entry, entry[4] + piece * rng.choice([300, 5000, 200000]))


def spoilt_file(rng, case):
    """Other ends of lines, a byte order mark, half a file, nothing, much of it."""
    path = rng.choice(sorted(case.lines))
    lines = case.lines[path]
    kind = rng.randrange(9)
    if kind == 0:
        lines[:] = [line + "\r" for line in lines]
    elif kind == 1:
        lines[:] = "\r".join(lines).split("\n")
    elif kind == 2:
        lines[0] = "\ufeff" + lines[0]
    elif kind == 3:
        del lines[rng.randrange(len(lines)) :]
    elif kind == 4:
        text = "\n".join(lines).encode("utf-16", "replace")
        lines[:] = [text.decode("utf-8", "surrogateescape")]
    elif kind == 5:
        lines.insert(0, "# " + "x" * 3000000)
    elif kind == 6:
        lines.extend(["set Title = a"] * 50000)
    elif kind == 7:
        lines[-1] += " \\"
    else:
        place = rng.randrange(len(lines))
        lines[place] = "\\\n".join(lines[place]) or "\\"
    return f"file spoilt in way {kind}"


def spoilt_include(rng, case):
    path = rng.choice(sorted(case.lines))
    lines = case.lines[path]
    name = rng.choice(INCLUDED).replace("MAIN", case.main.split("/")[-1])
    name = rng.choice([name] * 20 + ["x" * 300, "a/" * 3000, "\x1b[31m", "a\x00b"])
    places = [n for n, line in enumerate(lines) if line.startswith("include")]
    if places and rng.random() < 0.5:
        lines[rng.choice(places)] = "include " + name
    else:
        lines.insert(rng.randrange(len(lines) + 1), "include " + name)
    return f"include {short(repr(name))}"


def spoilt_keyword(rng, case):
    path = rng.choice(sorted(case.lines))
    lines = case.lines[path]
    number = rng.randrange(len(lines))
    first, *rest = lines[number].strip().split(" ", 1) or [""]
    word = rng.choice(
        ["SET", "sett", "Set", "st", "", "end", "END", "subsection", "include", "=", "{"]
        + ["set\t", "\x1b[2J", "x" * 2000, "set set", "#"]
    )
    lines[number] = " ".join([word, *rest])
    return f"'{first}' replaced by {short(repr(word))}: {short(lines[number])}"


def other_text(rng, case):
    entry = choose(rng, case.entries(), lambda kind: kind == "text")
    value = rng.choice(NAMES + CONTROL + INCLUDED + ["/dev/zero", "%d" * 50])
    return entry and change(case, entry, value)


def more_outputs(rng, case):
    entries = [e for e in case.entries() if e[3] in ("Cycles", "Number of outputs")]
    if not entries:
        return None
    value = str(rng.choice([0, 1, 2, 3, 5, 50, 9999, 999999999]))
    return change(case, rng.choice(entries), value)


#: How often each is taken.
WEIGHTS = {
    other_unit: 10,
    no_unit: 8,
    spoilt_unit: 9,
    other_number: 9,
    scaled_number: 12,
    other_integer: 4,
    other_expression: 2,
    new_function: 7,
    other_name: 5,
    other_list: 4,
    other_word: 7,
    new_entry: 14,
    deleted_line: 4,
    doubled_line: 2,
    moved_line: 2,
    swapped_values: 4,
    renamed: 4,
    spoilt_block: 4,
    swapped_bodies: 2,
    random_bytes: 3,
    control_characters: 3,
    long_value: 3,
    spoilt_file: 3,
    spoilt_include: 4,
    spoilt_keyword: 2,
    other_text: 1,
    more_outputs: 1,
}


def mutate(rng, case, words, weights=None):
    """Changes the case once or more often and says how."""
    ways = weights or WEIGHTS
    wanted = rng.choice([1, 1, 1, 1, 1, 1, 2, 2, 3, 5])
    said = []
    for _ in range(20):
        if len(said) == wanted:
            break
        way = rng.choices(list(ways), list(ways.values()))[0]
        needs_words = way in (other_word, new_entry)
        done = way(rng, case, words) if needs_words else way(rng, case)
        if done:
            said.append(done)
        for lines in case.lines.values():
            if not lines:
                lines.append("")
    return "; ".join(said)
