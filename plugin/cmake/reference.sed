# What Markdown on a code host means, as Doxygen means it: formulas, pictures beside the pages, headers.
/^```math$/,/^```$/ {
  s/^```math$/\\f[/
  s/^```$/\\f]/
}
s#\]\((\.\./)+(assets/)?(charts|pictures)/#](#g
s#\]\((\.\./)+include/sherd/([a-z_]+\.h)\)#](@ref \2)#g
s#\[MIT\]\(LICENSE\)#MIT#
s#\[([a-z_]+\.h)\]\(\1\)#\1#
s/\[([^]]+)\]\(#[a-z-]+\)/\1/g
s/\]\(([a-z_./]*\.md)#[a-z0-9-]+\)/](\1)/g
s#\[([^]]+)\]\([a-z_./]*bullet_demos/[a-z_]+(/[a-z_]+\.cpp)?\)#\1#g
