// The viewer's buttons, lists and words. Names come from files of strangers: they are text, never markup.

function element(tag, className, ...content) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  made.append(...content);
  return made;
}

function button(name, title, onClick) {
  const made = element("button", "", name);
  made.type = "button";
  made.title = title;
  made.setAttribute("aria-label", title);
  made.addEventListener("click", onClick);
  return made;
}

/** A choice of words. \param options  [value, words] each */
function choice(name, options, onChange) {
  const select = element("select");
  for (const [value, words] of options) {
    const option = element("option", "", words);
    option.value = value;
    select.append(option);
  }
  select.addEventListener("change", () => onChange(select.value));
  return { label: element("label", "", name + " ", select), select };
}

function slider(name, onInput) {
  const input = element("input");
  input.type = "range";
  input.min = 0;
  input.max = 1000;
  input.step = "any";
  input.setAttribute("aria-label", name);
  input.addEventListener("input", () => onInput(Number(input.value)));
  return input;
}

function check(name, on, onChange) {
  const input = element("input");
  input.type = "checkbox";
  input.checked = on;
  input.addEventListener("change", () => onChange(input.checked));
  return { label: element("label", "", input, " " + name), input };
}

/** "1:02:09", "4:07". */
function clockWords(seconds) {
  const whole = Math.floor(seconds + 0.5);
  const two = (value) => String(value).padStart(2, "0");
  const hours = Math.floor(whole / 3600);
  const minutes = Math.floor(whole / 60) % 60;
  return (hours > 0 ? hours + ":" + two(minutes) : minutes) + ":" + two(whole % 60);
}

/** Lengths and feeds in the page's unit. */
class Units {
  constructor(inch) {
    this.inch = inch;
  }

  length(mm) {
    return this.inch ? (mm / 25.4).toFixed(3) + " in" : mm.toFixed(2) + " mm";
  }

  feed(mmPerMin) {
    return this.inch ? (mmPerMin / 25.4).toFixed(1) + " in/min" : mmPerMin.toFixed(0) + " mm/min";
  }
}

const kKeyWords = [["Space", "play, pause"], ["← →", "back, on"], ["Page up, down", "operation before, next"],
  ["Home, End", "start, end"], ["+ −", "faster, slower"], ["1 2 3 4", "corner, top, front, right"],
  ["S P X H T R", "stock, part, fixtures, holder and tool, path, all paths"], ["C", "colours"], ["L", "light, dark"],
  ["Esc", "choose nothing"]];

function keyList() {
  const list = element("ul", "viewer-keys");
  for (const [keys, words] of kKeyWords) list.append(element("li", "", element("b", "", keys), " " + words));
  return element("details", "", element("summary", "", "Keys"), list);
}

/** A list of buttons, of which some are marked. */
class PickList {
  constructor(title, onPick) {
    this.onPick = onPick;
    this.list = element("ul", "viewer-list");
    this.list.setAttribute("aria-label", title);
    this.element = element("div", "", element("b", "", title), this.list);
    this.buttons = new Map();
  }

  /** \param items  [id, words] each */
  fill(items) {
    this.buttons.clear();
    this.list.replaceChildren(...items.map(([id, words]) => {
      const pick = element("button", "", words);
      pick.type = "button";
      pick.addEventListener("click", () => this.onPick(id));
      this.buttons.set(id, pick);
      return element("li", "", pick);
    }));
  }

  mark(ids, isScrolled) {
    for (const [id, pick] of this.buttons) {
      const marked = ids.includes(id);
      if (marked !== pick.classList.contains("marked")) {
        pick.classList.toggle("marked", marked);
        pick.setAttribute("aria-pressed", marked);
      }
    }
    const first = this.buttons.get(ids[0]);
    // Not scrollIntoView(), which would move the page as well.
    if (first && isScrolled) this.list.scrollTop = first.parentElement.offsetTop - this.list.clientHeight / 2;
  }
}
