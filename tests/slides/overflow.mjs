// overflow.mjs MODULES DECK.html...: opens the decks in Chromium and names each slide whose content does not fit, and each
// picture that does not show. Exit status 1 if there is any.
import { createRequire } from 'node:module'
import { resolve } from 'node:path'

const [modules, ...decks] = process.argv.slice(2)
const puppeteer = createRequire(resolve(modules, 'x.js'))('puppeteer-core')
const browser = await puppeteer.launch({ executablePath: process.env.CHROMIUM, args: ['--no-sandbox'] })

// In the page: what is wrong with each slide, as "number: what".
function faults() {
  const found = []
  document.querySelectorAll('section').forEach(slide => {
    if (!slide.id) return // the layer of a background picture
    const say = what => found.push(`slide ${slide.id}: ${what}`)
    const page = slide.getBoundingClientRect(), unit = page.height / 720
    const label = element => `<${element.tagName.toLowerCase()}> ${element.textContent.trim().slice(0, 40)}`
    for (const element of slide.querySelectorAll('*')) {
      if (element.closest('footer') || element.tagName === 'FOOTER' || element.closest('mjx-container svg')) continue
      const box = element.getBoundingClientRect()
      if (!box.width || !box.height) continue
      if (box.bottom > page.bottom - 52 * unit) say(`${Math.round((box.bottom - page.bottom) / unit + 52)} px too low: ${label(element)}`)
      else if (box.right > page.right - 40 * unit || box.left < page.left + 40 * unit) say(`too wide: ${label(element)}`)
      else if (element.matches('pre') && element.scrollWidth > element.clientWidth + 1) say(`a line is too long: ${label(element)}`)
      else continue
      break
    }
    for (const image of slide.querySelectorAll('img'))
      if (!image.naturalWidth) say(`a picture does not show: ${image.alt}`)
      else if (image.getBoundingClientRect().height < 140 * unit) say(`a picture is squeezed: ${image.alt}`)
  })
  return found
}

let count = 0
for (const deck of decks) {
  const page = await browser.newPage()
  const told = []
  page.on('pageerror', error => told.push(`error: ${error.message}`))
  page.on('request', request => /^https?:/.test(request.url()) && told.push(`asks the network for ${request.url()}`))
  await page.setViewport({ width: 1280, height: 720 })
  await page.emulateMediaType('print')
  await page.goto(`file://${resolve(deck)}`)
  told.push(...await page.evaluate(faults))
  for (const fault of told) console.log(`${deck}: ${fault}`)
  count += told.length
  await page.close()
}
await browser.close()
console.log(`${decks.length} decks opened, ${count} faults`)
process.exit(count ? 1 : 0)
