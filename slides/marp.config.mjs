// How Marp makes the decks: what a deck names is put into it, so that each HTML file can be carried about alone.
//
//   ![...](../chapters/01_ray_casting/picture.png)             a picture of the course, embedded
//   ![...](../out/compare_bounce.svg "./course compare")       one that a command makes; until then, the command is shown
//   <!-- from chapters/01_ray_casting/ray.hpp -->              before a listing: shows where the code stands
//   <!-- table from FILE: column | column; rows a | b -->       columns of a table in a lesson, as it stands there today
//   <!-- exercises 01 -->                                      the exercises that there are for a chapter
import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { dirname, extname, join } from 'node:path'
import { fileURLToPath } from 'node:url'

const slides = dirname(fileURLToPath(import.meta.url))
const kinds = { '.png': 'image/png', '.jpg': 'image/jpeg', '.svg': 'image/svg+xml' }

function embedded(file) {
  const kind = kinds[extname(file)]
  if (!kind) throw new Error(`${file}: a deck can show .png, .jpg and .svg`)
  if (kind !== kinds['.svg']) return `data:${kind};base64,${readFileSync(file).toString('base64')}`
  // Decks are light, whatever the reader's desktop is; and a plot is read from the back row.
  const drawing = readFileSync(file, 'utf8')
    .replaceAll('(prefers-color-scheme: dark)', 'not all').replaceAll('font-size="14.00"', 'font-size="17.00"')
  return `data:${kind};base64,${Buffer.from(drawing).toString('base64')}`
}

function picture(whole, alt, path, title) {
  if (/^[a-z]+:/.test(path)) throw new Error(`${path}: a deck shows only the course's own pictures`)
  const file = join(slides, path)
  if (existsSync(file)) return `![${alt}](${embedded(file)})`
  if (!title) throw new Error(`${path}: there is no such picture`)
  return `<div class="missing">This plot is drawn by <code>${title}</code></div>`
}

const cells = row => row.split(/(?<!\\)\|/).slice(1, -1).map(cell => cell.trim())
const links = /\[([^\]]*)\]\([^)]*\)/g // they lead on from the lesson, not from a deck
const plain = cell => cell.replace(/[*`$]/g, '').trim()

function table(whole, path, columns, rows) {
  const wanted = columns.split('|').map(plain), kept = rows && rows.split('|').map(plain)
  const lines = readFileSync(join(slides, '..', path), 'utf8').split('\n')
  for (let head = 0; head + 1 < lines.length; ++head) {
    if (!lines[head].startsWith('|') || !/^\|[ :|-]+\|$/.test(lines[head + 1])) continue
    const places = wanted.map(name => cells(lines[head]).map(plain).indexOf(name))
    if (places.includes(-1)) continue
    const chosen = [lines[head], lines[head + 1]]
    for (let row = head + 2; lines[row]?.startsWith('|'); ++row)
      if (!kept || kept.includes(plain(cells(lines[row])[0]))) chosen.push(lines[row])
    const source = dirname(path) === '.' ? '' : `<p class="source">${path}</p>\n\n`
    return source + chosen.map(row => `| ${places.map(place => cells(row)[place]).join(' | ')} |`).join('\n').replace(links, '$1')
  }
  throw new Error(`${path}: no table has the columns ${columns}`)
}

function exercises(whole, chapter) {
  const folder = join(slides, '../exercises')
  const names = existsSync(folder) ? readdirSync(folder).filter(name => name.startsWith(`${chapter}_`)) : []
  const title = name => readFileSync(join(folder, name, 'README.md'), 'utf8').match(/^# (?:\d+ · )?(.*)$/m)[1]
  const lines = names.sort().map(name => `<li>${title(name)}: <code>./course exercise ${name}</code></li>`)
  return `<ul class="exercises">${lines.join('') || '<li><code>./course exercise list</code></li>'}</ul>\n`
}

function filled(deck) {
  return deck
    .replace(/^<!-- from (\S+) -->$/gm, '<p class="source">$1</p>\n')
    .replace(/^<!-- table from (\S+): ([^;\n]+?)(?:; rows ([^\n]+?))? -->$/gm, table)
    .replace(/^<!-- exercises (\d\d) -->$/gm, exercises)
    .replace(/!\[([^\]]*)\]\(([^)\s]+)\s*(?:"([^"]*)")?\s*\)/g, picture)
}

function course(markdown) {
  markdown.validateLink = () => true // embedded drawings, too
  markdown.core.ruler.after('normalize', 'course', state => { state.src = filled(state.src) })
}

export default {
  html: true,
  themeSet: join(slides, 'theme.css'),
  options: { emoji: { shortcode: false, unicode: false }, math: 'mathjax', markdown: { breaks: false } },
  engine: ({ marp }) => marp.use(course),
}
