#!/usr/bin/env ruby
# SPDX-License-Identifier: MIT
# stack-10 by libvips, one lazy pipeline over all layers.
#
# stack10_vips.rb FOLDER OUTPUT: reads what patina_bench --write-stack10 wrote, writes
# OUTPUT/base.png and OUTPUT/packed.png.
require 'vips'

def read(name)
  Vips::Image.new_from_file("#{FOLDER}/#{name}.tif").cast(:float) / 255
end

def blended(mode, below, own)
  case mode
  when 'normal' then own
  when 'multiply' then below * own
  when 'screen' then below + own - below * own
  when 'overlay'
    light = (below * -1 + 1) * (own * -1 + 1) * -2 + 1
    (below <= 0.5).ifthenelse(below * own * 2, light)
  when 'add'
    total = below + own
    (total <= 1).ifthenelse(total, 1)
  when 'soft-light'
    low = ((below * 16 - 12) * below + 4) * below
    root = (below <= 0.25).ifthenelse(low, below**0.5)
    twice = own * 2 - 1
    (own <= 0.5).ifthenelse(below + twice * (below - below * below),
                            below + twice * (root - below))
  end
end

def laid(below, own, cover)
  below + (own - below) * cover
end

def write(path, image)
  (image * 255 + 0.5).cast(:uchar).copy(interpretation: :srgb).write_to_file(path)
end

FOLDER, OUTPUT = ARGV
color = read('base')
rough = color[0] * 0 + 128.0 / 255
metal = color[0] * 0
File.readlines("#{FOLDER}/stack10.txt").each_with_index do |line, i|
  mode, opacity, metalness = line.split
  own = read("color#{i}")
  cover = own[3] * read("mask#{i}") * opacity.to_f
  color = laid(color, blended(mode, color, own[0..2]), cover)
  rough = laid(rough, read("roughness#{i}"), cover)
  metal += (metal * -1 + metalness.to_f) * cover
end
write("#{OUTPUT}/base.png", color)
write("#{OUTPUT}/packed.png", (rough * 0 + 1).bandjoin([rough, metal]))
