// A small shop: a program with a sub of its own, a file that it and another file call, and a Fanuc program.

export const files = {
  'main.ngc': `(drills, and faces where the blank is thick)
o<drill> sub
  o100 repeat [3]
    G0 X#1
    o110 if [#1 LT 0]
      o<drill> return
    o110 endif
  o100 endrepeat
o<drill> endsub
G21 G90
o<drill> call [10]
o100 while [#5070 EQ 0]
  o120 if [#5420 GT 5]
    o<face> call [30] [40]
  o120 elseif [#5420 GT 3]
    o100 break
  o120 else
    o<drill> call [20]
  o120 endif
o100 endwhile
M2
`,
  'face.ngc': `(faces one blank)
o<face> sub
  #<width> = #1
  #<length> = #2
  G0 X#<width> Y#<length>
  o<face> return [1]
o<face> endsub
`,
  'both.ngc': `(faces two blanks)
o<both> sub
  o<face> call [1] [2]
  o<face> call [3] [4]
o<both> endsub
`,
  'fanuc.ngc': `G21 G90
M98 P100 L2
M2
O100
  G0 X1
M99
`,
};
