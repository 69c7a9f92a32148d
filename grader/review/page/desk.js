// STAFF ONLY. The desk's page: it shows what the server sends, and sends what a TA decides.
"use strict";

const POLL = 5000; // ms
const SENT_ALONG = 40; // candidates for the next item
const $ = (id) => document.getElementById(id);
const list = $("list"), who = document.querySelector(".desk").dataset.who;
let busy = false;

const rows = () => [...list.children];
const rowOf = (key) => rows().find((row) => row.dataset.key === key);
const article = () => document.querySelector("#item > article");
const current = () => article().dataset.key;
const isOpen = () => document.querySelector("dialog[open]");

function tell(text, bad = false) {
  $("told").textContent = text;
  $("told").classList.toggle("bad", bad);
}

// Without capitals and accents.
const plain = (text) => text.toLowerCase().normalize("NFD").replace(/\p{M}/gu, "").replaceAll("đ", "d").replaceAll("ø", "o").replaceAll("ł", "l");

// The list: filters, order, and where we are in it.
function choose() {
  const words = plain($("search").value).split(/\s+/).filter(Boolean);
  let left = 0;
  for (const row of rows()) {
    const { owner, kind, words: more } = row.dataset, text = plain(`${row.textContent} ${more} ${row.dataset.section}`);
    const decided = row.classList.contains("decided");
    row.hidden = (($("whose").value !== "*" && owner !== $("whose").value) ||
      ($("kind").value && kind !== $("kind").value) || ($("undecided").checked && decided) || !words.every((word) => text.includes(word)));
    left += !row.hidden && !decided;
  }
  const count = rows().filter((row) => !row.hidden).length;
  $("count").textContent = count ? `${count} shown, ${left} of them undecided` : "Nothing matches.";
}

function sort() {
  const lost = $("sort").value === "lost";
  list.append(...rows().sort((a, b) => (lost ? b.dataset.lost - a.dataset.lost : 0) || a.place - b.place));
  choose();
}

// The Tab key reaches one row of the list.
function mark(scrolls) {
  for (const link of list.querySelectorAll("[aria-current]")) {
    link.removeAttribute("aria-current");
    link.tabIndex = -1;
  }
  const row = rowOf(current());
  if (!row) return;
  row.firstElementChild.setAttribute("aria-current", "true");
  row.firstElementChild.tabIndex = 0;
  if (!scrolls) return;
  // The page does not scroll with it.
  const top = row.offsetTop - list.offsetTop;
  if (top < list.scrollTop || top + row.offsetHeight > list.scrollTop + list.clientHeight) list.scrollTop = top - list.clientHeight / 3;
}

// Keys of the rows before this one and after it that the filters show. They may hide this one.
function around() {
  const all = rows(), at = all.findIndex((row) => row.dataset.key === current());
  const keys = (some) => some.filter((row) => !row.hidden).map((row) => row.dataset.key);
  return { before: keys(all.slice(0, Math.max(at, 0))), after: keys(all.slice(at + 1)) };
}

function others() {
  const { before, after } = around();
  return [...after, ...before];
}

function take(answer) {
  for (const { key, html } of answer.rows) {
    const old = rowOf(key), holder = document.createElement("ol");
    holder.innerHTML = html;
    const row = holder.firstElementChild;
    if (row) row.place = old ? old.place : rows().length;
    if (old && row) old.replaceWith(row);
    else if (old) old.remove();
    else if (row) list.append(row);
  }
  list.dataset.stamp = answer.stamp;
  $("progress").innerHTML = answer.progress;
  if (answer.item && !isOpen()) {
    $("item").innerHTML = answer.item;
    sessionStorage.setItem("item", current());
    if ($("item").getBoundingClientRect().top < 0) $("told").scrollIntoView();
    article().querySelector("h2").focus({ preventScroll: true });
  }
  choose();
  mark(answer.item);
}

async function ask(path, body) {
  const answer = await fetch(path, body ? { method: "POST", body: JSON.stringify(body) } : {});
  if (!answer.headers.get("Content-Type").startsWith("application/json")) throw new Error(await answer.text());
  return { ok: answer.ok, ...(await answer.json()) };
}

// One at a time: a key that is pressed twice decides one item.
async function alone(work) {
  if (busy) return;
  busy = true;
  $("item").setAttribute("aria-busy", "true");
  try {
    await work();
  } catch (error) {
    tell(error instanceof TypeError ? "hairgrade review does not answer: it has ended. Nothing more is saved; start it again and open its new address." : error.message, true);
  }
  busy = false;
  $("item").setAttribute("aria-busy", "false");
}

const show = (key) => alone(async () => {
  const answer = await ask(`item/${list.dataset.stamp}/${encodeURIComponent(key)}`);
  take(answer);
  tell(answer.told, !answer.ok);
});

function step(by) {
  const { before, after } = around(), key = by > 0 ? after[0] : before.at(-1);
  if (key !== undefined) show(key);
  else tell(by > 0 ? "This is the last one." : "This is the first one.");
}

// With nothing in `then` this item stays: answers alone decide a request.
const send = (what, stays = false) => alone(async () => {
  const { key, version, accept } = article().dataset, dialog = isOpen();
  const goesOn = !stays && (accept !== "answer" || what.do === "answer" || what.do === "skip");
  const answer = await ask("save", { ...what, key, version, then: goesOn ? others().slice(0, SENT_ALONG) : [], stamp: Number(list.dataset.stamp) });
  if (!answer.ok && dialog) {
    // The texts stay, and the next try knows about the change.
    dialog.querySelector(".told").textContent = answer.told;
    article().dataset.version = answer.version || version;
    return;
  }
  dialog?.close();
  take(answer);
  tell(answer.told, !answer.ok);
});

function open(name) {
  const dialog = $(name);
  if (!dialog) return;
  dialog.showModal();
  const why = dialog.querySelector("[name=text]");
  if (name === "points") {
    const [, points] = /: (\S+) of/.exec(dialog.querySelector("[name=place]").selectedOptions[0]?.textContent ?? "") ?? [];
    dialog.querySelector("[name=number]").value = points ?? "";
    dialog.querySelector("[name=number]").select();
    if (!why.value) why.value = sessionStorage.getItem("why") ?? "After a look at your code.";
  } else if (name === "comment" && dialog.querySelector(".used")) {
    dialog.querySelector(".used").focus();
  } else if (why) {
    why.focus();
  }
}

function submit(form, stay) {
  const fields = Object.fromEntries(new FormData(form)), what = { do: form.dataset.do, ...fields };
  if (form.dataset.do === "points") sessionStorage.setItem("why", fields.text);
  send(what, stay);
}

const ACTIONS = {
  next: () => step(1),
  back: () => step(-1),
  undecided: () => send({ do: "skip" }),
  accept: () => send({ do: "accept" }),
  reopen: () => send({ do: "reopen" }, true),
  undo: () => send({ do: "undo" }, true),
  unset: () => send({ do: "unset" }),
  late_days: () => send({ do: "late_days" }),
  points: () => open("points"),
  comment: () => open("comment"),
  excuse: () => open("excuse"),
  answer: () => open("answer"),
  help: () => open("help"),
};
// While an answer is on its way, the item is not the one that it would be about.
const act = (name) => busy || ACTIONS[name]();
const KEYS = { j: "next", k: "back", u: "undecided", e: "points", c: "comment", z: "undo", "?": "help" };

document.addEventListener("click", (event) => {
  const target = event.target.closest("[data-action], [data-comment], [data-close], #list a");
  if (!target) return;
  if (target.dataset.action) act(target.dataset.action);
  else if (target.dataset.comment) send({ do: "comment", comment: Number(target.dataset.comment), place: target.form.elements.place.value, line: target.form.elements.line.value });
  else if (target.closest("#list")) {
    event.preventDefault();
    show(target.parentNode.dataset.key);
  } else target.closest("dialog").close();
});

document.addEventListener("submit", (event) => {
  if (!event.target.dataset.do) return;
  event.preventDefault();
  submit(event.target, event.submitter?.value === "stay");
});

const writes = (element) => element.matches("input:not([type=checkbox]), textarea, select, [contenteditable]");
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey || event.isComposing || event.repeat || writes(event.target)) return;
  const dialog = isOpen();
  if (dialog?.id === "comment" && $("keys").checked && /^[1-9]$/.test(event.key)) {
    dialog.querySelectorAll("[data-comment]")[event.key - 1]?.click();
  } else if (dialog?.id === "comment" && event.key.length === 1 && !event.target.closest("button")) {
    dialog.querySelector("[name=text]").focus(); // and the key is its first letter
  } else if (!dialog && $("keys").checked) {
    const action = event.key === "a" ? article().dataset.accept : KEYS[event.key];
    if (!action) return;
    event.preventDefault(); // the letter is not for a field that opens now
    act(action);
  }
});

$("keys").checked = localStorage.getItem("keys") !== "off";
const useKeys = () => {
  localStorage.setItem("keys", $("keys").checked ? "on" : "off");
  document.body.classList.toggle("no-keys", !$("keys").checked);
};
$("keys").addEventListener("change", useKeys);
useKeys();
for (const id of ["search", "whose", "kind", "undecided"]) $(id).addEventListener("input", choose);
$("sort").addEventListener("input", sort);
rows().forEach((row, i) => { row.place = i; });

// Others work, too.
setInterval(() => {
  if (document.hidden || busy) return;
  const { key, version } = article().dataset;
  ask(`news/${list.dataset.stamp}/${encodeURIComponent(key)}`).then((answer) => {
    if (busy || current() !== key) return;
    take(answer);
    if (answer.version && answer.version !== version && article().dataset.version === version) tell("Somebody has just changed this item. Open it again to see how.");
  }, () => {});
}, POLL);

choose();
mark(true);
const wanted = decodeURIComponent(location.hash.slice(1)) || sessionStorage.getItem("item");
if (wanted && wanted !== current() && rowOf(wanted)) show(wanted);
