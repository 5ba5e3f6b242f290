'use strict';
// Tables that sort and filter, groups that show their cases, cases with their specification and the
// command that runs them again. Texts go in as texts, never as HTML.
(() => {
  const data = JSON.parse(document.getElementById('data').textContent);
  const pageOfRows = 200;
  document.body.classList.add('scripted');

  function element(name, text, attributes) {
    const made = document.createElement(name);
    if (text !== undefined) made.textContent = text;
    for (const key in attributes || {}) made.setAttribute(key, attributes[key]);
    return made;
  }

  function button(text, action, label) {
    const made = element('button', text, { type: 'button' });
    if (label) made.setAttribute('aria-label', label);
    made.addEventListener('click', action);
    return made;
  }

  // Numbers by size, then words, then what is missing.
  function compare(a, b) {
    const x = Number(a), y = Number(b);
    const ranks = [a, b].map(t => t === '–' || t === '' ? 2 : Number.isNaN(Number(t)) ? 1 : 0);
    if (ranks[0] !== ranks[1]) return ranks[0] - ranks[1];
    return ranks[0] === 0 ? x - y : a < b ? -1 : a > b ? 1 : 0;
  }

  function specification(group, one) {
    const difference = one[7];
    if (typeof difference === 'string') return difference;
    const lines = group.spec.split('\n');
    for (const [line, text] of difference) lines[line] = text;
    return lines.join('\n');
  }

  function row(cells, name) {
    const made = element('tr');
    for (const cell of cells) {
      const field = element(name || 'td');
      if (name) field.setAttribute('scope', 'col');
      const text = typeof cell === 'string' ? cell : '';
      if (text.length > 28) field.className = 'long';
      if (/^[0-9a-f]{32}$/.test(text)) {
        field.className = 'id';
        field.append(element('a', text.slice(0, 12), { href: '#case-' + text }));
      } else {
        field.append(cell);
      }
      made.append(field);
    }
    return made;
  }

  const dialog = document.getElementById('case');
  function openCase(study, group, one) {
    const close = button('Close', () => dialog.close());
    const list = element('dl');
    const entry = (key, value) => list.append(element('dt', key), element('dd', value));
    entry('study', study.name);
    entry('group', group.name);
    entry('status', data.statuses[one[3]] + (one[8] ? ': ' + one[8] : ''));
    study.measures.forEach((name, m) => entry(name, one[4][m]));
    entry('CPU time (s)', one[5]);
    entry('ns a point and step', one[6]);
    const command = /^\[adapter\]/m.test(specification(group, one))
      ? 'Another program ran it: sweep its study into a new store'
      : data.rerun + one[0];
    dialog.replaceChildren(
      close, element('h2', 'Case ' + one[0], { id: 'case_title', class: 'id' }), list,
      element('h3', 'Run it again'), element('pre', command, { tabindex: '0' }),
      element('h3', 'Specification'), element('pre', specification(group, one), { tabindex: '0' }));
    history.replaceState(null, '', '#case-' + one[0]);
    if (!dialog.open) dialog.showModal();
    close.focus();
  }
  dialog.addEventListener('close', () => history.replaceState(null, '', '#tables'));

  function casesTable(study, group) {
    const table = element('table');
    const head = element('thead');
    head.append(row(['case', study.level, 'seed', 'status', ...study.measures, 'CPU (s)',
      'ns/point/step'], 'th'));
    const body = element('tbody');
    for (const one of group.cases) {
      const open = button(one[0].slice(0, 12), () => openCase(study, group, one),
        'Specification and command of case ' + one[0]);
      open.className = 'id';
      body.append(row([open, one[1], one[2], data.statuses[one[3]], ...one[4], one[5], one[6]]));
    }
    table.append(head, body);
    return table;
  }

  function groupRow(study, number, cells) {
    const made = row(cells);
    const group = study.groups[number];
    let shown = null;
    const toggle = button('cases', () => {
      if (shown) {
        shown.remove();
        shown = null;
      } else {
        shown = element('tr', undefined, { class: 'cases' });
        const field = element('td', undefined, { colspan: cells.length + 1 });
        field.append(casesTable(study, group));
        shown.append(field);
        made.after(shown);
      }
      toggle.setAttribute('aria-expanded', shown !== null);
    }, 'Cases of ' + group.name);
    toggle.setAttribute('aria-expanded', 'false');
    const first = element('td');
    first.append(toggle);
    made.prepend(first);
    return made;
  }

  function setUp(table, study) {
    const box = document.getElementById('table_' + table.name);
    const body = box.querySelector('tbody');
    const heads = [...box.querySelectorAll('thead th')];
    const first = ['verdicts', 'comparison'].includes(table.name) ? 25 : pageOfRows;
    const state = { column: -1, down: false, words: [], shown: first };
    const old = box.querySelector('.count');
    if (old) old.remove();
    const tools = element('div', undefined, { class: 'tools' });
    const label = element('label', 'Filter ');
    const input = element('input', undefined, { size: '30', placeholder: 'words that a row has' });
    label.append(input);
    const count = element('span', '', { role: 'status', class: 'count' });
    tools.append(label, ' ', count);
    box.prepend(tools);
    const more = button('Show more rows', () => { state.shown += 1000; render(); });
    box.append(more);
    if (study) heads[0].before(element('th', 'cases', { scope: 'col' }));

    function render() {
      let numbers = table.rows.map((_, i) => i);
      if (state.words.length > 0) {
        numbers = numbers.filter(i => {
          const text = table.rows[i].join(' ').toLowerCase();
          return state.words.every(word => text.includes(word));
        });
      }
      if (state.column >= 0) {
        const cell = i => table.rows[i][state.column];
        const missing = i => cell(i) === '–' || cell(i) === '';
        numbers.sort((a, b) => {
          if (missing(a) !== missing(b)) return missing(a) ? 1 : -1;
          return (state.down ? -1 : 1) * compare(cell(a), cell(b)) || a - b;
        });
      }
      const some = numbers.slice(0, state.shown);
      body.replaceChildren(...some.map(i =>
        study ? groupRow(study, i, table.rows[i]) : row(table.rows[i])));
      count.textContent = some.length + ' of ' + table.rows.length + ' rows' +
        (numbers.length > some.length ? ' (' + numbers.length + ' match)' : '');
      more.hidden = numbers.length <= some.length;
    }

    heads.forEach((head, column) => {
      const name = head.textContent;
      const sort = button(name, () => {
        state.down = state.column === column && !state.down;
        state.column = column;
        heads.forEach(other => other.removeAttribute('aria-sort'));
        heads.forEach((other, c) => { other.firstChild.textContent = table.columns[c]; });
        head.setAttribute('aria-sort', state.down ? 'descending' : 'ascending');
        sort.textContent = name + (state.down ? ' ▼' : ' ▲');
        render();
      });
      head.replaceChildren(sort);
    });
    input.addEventListener('input', () => {
      state.words = input.value.toLowerCase().split(/\s+/).filter(word => word !== '');
      state.shown = first;
      render();
    });
    render();
  }

  for (const table of data.tables) {
    setUp(table, data.studies.find(study => study.table === table.name));
  }

  function find(id) {
    if (id === '') return false;
    for (const study of data.studies) {
      for (const group of study.groups) {
        const one = group.cases.find(entry => entry[0].startsWith(id));
        if (one) {
          openCase(study, group, one);
          return true;
        }
      }
    }
    return false;
  }
  const form = document.getElementById('find');
  if (form) {
    form.addEventListener('submit', event => {
      event.preventDefault();
      const found = find(form.elements.id.value.trim().toLowerCase());
      form.querySelector('[role=status]').textContent = found ? '' : 'no such case';
    });
  }
  const openFromAddress = () => {
    if (location.hash.startsWith('#case-')) find(location.hash.slice(6));
  };
  addEventListener('hashchange', openFromAddress);
  openFromAddress();
})();
