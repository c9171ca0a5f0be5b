// index.mjs FOLDER: writes FOLDER/index.html, which leads to every deck that was made there, and the decks' covers.
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { dirname, extname, join } from 'node:path'
import { fileURLToPath } from 'node:url'

const slides = dirname(fileURLToPath(import.meta.url)), folder = process.argv[2]
const escaped = text => text.replace(/[&<>"]/g, letter => `&#${letter.charCodeAt(0)};`)

// The front matter's title and description, the number of slides, the first picture.
function deck(file) {
  const text = readFileSync(join(slides, file), 'utf8'), name = file.slice(0, -3)
  const said = key => escaped(text.match(new RegExp(`^${key}: (.*)$`, 'm'))[1])
  const picture = text.match(/!\[[^\]]*\]\((\S+)\)/)[1], cover = `covers/${name}${extname(picture)}`
  copyFileSync(join(slides, picture), join(folder, cover))
  const count = text.replace(/^```[^]*?^```$/gm, '').split(/^---$/m).length - 2
  const pdf = existsSync(join(folder, `${name}.pdf`)) ? ` · <a href="${name}.pdf">PDF</a>` : ''
  return `<li><a class="deck" href="${name}.html"><img src="${cover}" alt="" loading="lazy"><span>${said('title')}</span></a>
    <p>${said('description')}</p><p class="soft">${count} slides${pdf}</p></li>`
}

mkdirSync(join(folder, 'covers'), { recursive: true })
const decks = readdirSync(slides).filter(name => name.endsWith('.md')).sort().map(deck)
const style = readFileSync(join(slides, 'theme.css'), 'utf8').match(/:root \{[^}]*\}/)[0]
writeFileSync(join(folder, 'index.html'), `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Slides · A ray tracer, chapter by chapter</title>
<style>
${style}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 78rem; padding: clamp(1.5rem, 5vw, 4rem) clamp(1rem, 4vw, 3rem); background: var(--paper);
  color: var(--ink); font: 1rem/1.5 var(--sans); }
h1 { font: 500 clamp(2rem, 5vw, 3.2rem)/1.15 var(--serif); margin: 0 0 0.8rem; }
p { margin: 0; } .soft { color: var(--soft); font-size: 0.9rem; } .lede { max-width: 44em; }
a { color: var(--accent); text-underline-offset: 0.2em; }
a:focus-visible { outline: 3px solid var(--focus); outline-offset: 3px; border-radius: 2px; }
ul { list-style: none; margin: 2.4rem 0 0; padding: 0; display: grid; gap: 2rem 1.6rem;
  grid-template-columns: repeat(auto-fill, minmax(min(100%, 15rem), 1fr)); }
img { display: block; width: 100%; aspect-ratio: 16 / 9; object-fit: cover; border-radius: 3px; margin-bottom: 0.6rem; }
.deck { display: block; color: inherit; text-decoration: none; font: 600 1.15rem/1.3 var(--serif); }
.deck:hover span { text-decoration: underline; }
kbd { font: 0.85em var(--mono); border: 1px solid var(--line); border-radius: 3px; padding: 0 0.35em; background: var(--raised); }
</style>
<main>
<h1>Slides</h1>
<p class="lede">One deck for each chapter. In a deck: arrows to move, <kbd>F</kbd> for the full screen, <kbd>P</kbd> for the
speaker's notes. Each deck is one file, and needs no network.</p>
<ul>
${decks.join('\n')}
</ul>
</main>
</html>
`)
