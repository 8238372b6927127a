// The page's small notes at the top: errors stay until they are dismissed, others go by themselves.

const noteMilliseconds = 4000;
const mostAtOnce = 4;

function make(tag, className, text) {
  const node = document.createElement(tag);
  if (className) node.className = className;
  if (text) node.textContent = text;
  return node;
}

export class Messages {
  #list;

  constructor(list) { this.#list = list; }

  /** Dismissible; read out at once. */
  error(text) { this.#add(text, 'alert').classList.add('error'); }

  /** Goes by itself; read out politely. */
  note(text) {
    const box = this.#add(text, 'status');
    setTimeout(() => box.remove(), noteMilliseconds);
  }

  /** Stays until it is dismissed; read out politely. */
  tell(text) { this.#add(text, 'status'); }

  /** With a text to take along by hand. */
  copyable(text, value) {
    const box = this.#add(text, 'status');
    const field = make(value.includes('\n') ? 'textarea' : 'input');
    field.readOnly = true;
    field.value = value;
    field.setAttribute('aria-label', text);
    box.lastChild.before(field);
    field.select();
  }

  /** With something to be done about it; stays until that is done or it is dismissed. */
  offer(text, label, action) {
    const box = this.#add(text, 'status');
    const button = make('button', 'action', label);
    button.type = 'button';
    button.addEventListener('click', () => {
      box.remove();
      action();
    });
    box.lastChild.before(button);
    return box;
  }

  dismissAll() { this.#list.replaceChildren(); }

  #add(text, role) {
    const box = make('div', 'message');
    box.setAttribute('role', role);
    const close = make('button', '', '×');
    close.type = 'button';
    close.setAttribute('aria-label', 'Dismiss');
    close.addEventListener('click', () => box.remove());
    box.append(make('p', '', text), close);
    while (this.#list.childElementCount >= mostAtOnce) this.#list.firstChild.remove();
    this.#list.append(box);
    return box;
  }
}
