import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { crc32 } from 'node:zlib';
import { Photo, read_exif } from '../../pkg/node.js';
import { file, folder, json, samplePair, tiepoint } from './command.js';

const { at } = samplePair();

/** A PNG of the sample with an XMP packet of these attributes behind its header.  @param {string} name @param {string} attributes */
function withXmp(name, attributes) {
  const png = readFileSync(join(at, name));
  const packet = `<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"><rdf:Description ${attributes}/></rdf:RDF></x:xmpmeta>`;
  const chunk = Buffer.concat([Buffer.from('iTXtXML:com.adobe.xmp\0\0\0\0\0'), Buffer.from(packet)]);
  const ends = [Buffer.alloc(4), Buffer.alloc(4)];
  ends[0]?.writeUInt32BE(chunk.length - 4);
  ends[1]?.writeUInt32BE(crc32(chunk));
  const header = 8 + 25;
  return Buffer.concat([png.subarray(0, header), ends[0] ?? png, chunk, ends[1] ?? png, png.subarray(header)]);
}

/** Both photos with such packets.  @param {string} attributes @returns {[string, string]} */
function pairWith(attributes) {
  const to = folder();
  for (const name of ['left.png', 'right.png']) file(to, name, withXmp(name, attributes));
  return [join(to, 'left.png'), join(to, 'right.png')];
}

const drone =
  'xmlns:drone-dji="http://www.dji.com/drone-dji/1.0/" drone-dji:DewarpData="2024-01-01;604.0,603.6,1,-2,0.01,0,0,0,0" drone-dji:GimbalYawDegree="+1.5" ' +
  'drone-dji:GimbalPitchDegree="-90.00" drone-dji:GimbalRollDegree="+0.00" drone-dji:RelativeAltitude="+70.5"';

test('a pair is oriented by the cameras of its files, whose origin is told', () => {
  const pair = pairWith(drone);
  // The principal point of the sample is not in its middle: gradients would see a rotation alone.
  const moments = ['--strategy', 'moments'];
  const result = json('match', ...pair, ...moments);
  assert.ok(result.orientation, JSON.stringify(result.no_orientation));
  assert.deepEqual(
    result.file_cameras.map((/** @type {{ origin: string }} */ { origin }) => origin),
    ['xmp_calibration', 'xmp_calibration'],
  );
  const { stdout } = tiepoint('match', ...pair, ...moments);
  assert.ok(stdout.includes(`camera of ${pair[0]}: 603.8 px, from XMP (calibrated)`), stdout);
});

test('a panorama is not oriented, and why is told', () => {
  const pair = pairWith('xmlns:GPano="http://ns.google.com/photos/1.0/panorama/" GPano:ProjectionType="equirectangular"');
  const result = json('match', ...pair);
  assert.equal(result.no_orientation.kind, 'panorama');
  const { stdout } = tiepoint('match', ...pair);
  assert.ok(stdout.startsWith('Not oriented: the left image is a panorama') && stdout.includes(`caution, ${pair[1]}: a panorama (equirectangular)`), stdout);
});

test('the package reads what a drone recorded', () => {
  const bytes = withXmp('left.png', drone);
  const { drone: recorded } = Photo.decode(bytes).info();
  assert.equal(recorded?.relative_height_m, 70.5);
  assert.deepEqual(recorded?.gimbal, { yaw_deg: 1.5, pitch_deg: -90, roll_deg: 0 });
  assert.deepEqual(read_exif(bytes, 450, 700).drone, recorded);
});
