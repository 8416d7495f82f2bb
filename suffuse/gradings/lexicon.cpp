#include "suffuse/gradings/lexicon.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace suffuse::gradings {

namespace {

/// Words of one meaning, with a comma after each but the last. A blank ends one that is whole where only beginnings
/// count.
template <class Meaning>
struct Words {
    Meaning meaning;
    std::string_view words;
};

/// Whether any of the words is so.
template <class Test>
bool any_word(std::string_view words, const Test& test) {
    for (std::size_t begin = 0; begin <= words.size();) {
        const std::size_t end = std::min(words.find(',', begin), words.size());
        if (test(words.substr(begin, end - begin))) {
            return true;
        }
        begin = end + 1;
    }
    return false;
}

/// The meaning of the row that has the word.
template <class Meaning, std::size_t N>
std::optional<Meaning> meaning_of(const std::array<Words<Meaning>, N>& rows, std::string_view word) {
    const auto row = std::ranges::find_if(rows, [word](const Words<Meaning>& known) {
        return any_word(known.words, [word](std::string_view one) { return one == word; });
    });
    return row == rows.end() ? std::nullopt : std::optional(row->meaning);
}

// Of a word that holds several, the longest counts, and of these the first. One of less than five letters is a word of
// its own.
constexpr auto roles = std::to_array<Words<Role>>({
    // English
    {Role::Size, "d,diam,diameter,size,sizes,grainsize,opening,aperture"},
    {Role::Sieve, "sieve,sieves,screen"},
    {Role::Number, "mesh,no,number,id,nos,designation"},
    {Role::Passing, "passing,passed,passes,pass,finer,undersize,under,smaller"},
    {Role::Retained, "retained,retaining,ret"},
    {Role::Coarser, "coarser,oversize,larger"},
    {Role::Cumulative, "cum,cumul,total,accumulated"},
    {Role::OnOne, "individual,each,on,partial"},
    {Role::Percent, "percent,percentage,pct"},
    {Role::Fraction, "fraction,ratio,proportion"},
    {Role::Mass, "mass,weight,wt,g,kg,grams,gram,gr"},
    {Role::Count, "count,counts,stones,pebbles,anzahl,nombre,conteo"},
    {Role::By, "by"},
    {Role::Tare, "tare,empty"},
    {Role::And, "plus,and,with"},
    {Role::Gross, "gross,brutto,brut,bruto,lordo"},
    {Role::Soil, "soil"},
    {Role::Sample, "sample,specimen,borehole,bh,boring,point,pointid,hole,location,test,pit"},
    {Role::Depth, "depth,top,bottom"},
    {Role::Phi, "phi"},
    {Role::Filler,
     "name,ref,than,of,the,particle,grain,standard,volume,vol,density,diff,differential,frequency,share,shares"},
    // French
    {Role::Size, "diametre,ouverture,maille,taille,dimension"},
    {Role::Sieve, "tamis"},
    {Role::Passing, "passant,tamisat,inferieur"},
    {Role::Retained, "refus,retenu"},
    {Role::OnOne, "partiel,sur"},
    {Role::Percent, "pourcentage"},
    {Role::Mass, "masse,poids"},
    {Role::Tare, "vide"},
    {Role::And, "avec,et"},
    {Role::Soil, "sol"},
    {Role::Sample, "echantillon,sondage"},
    {Role::Depth, "profondeur,prof"},
    {Role::Number, "numero"},
    {Role::Filler, "des,de,du,la,les,en,grains"},
    // German
    {Role::Size, "durchmesser,korngro,siebweite,maschenweite,lochweite,offnung,oeffnung,siebgro"},
    {Role::Sieve, "sieb,siebe"},
    {Role::Passing, "durchgang,durchgange,feiner"},
    {Role::Retained, "ruckstand,rueckstand"},
    {Role::Coarser, "grober,groeber"},
    {Role::Cumulative, "summe,kumul,gesamt"},
    {Role::OnOne, "einzel,auf,je"},
    {Role::Percent, "prozent"},
    {Role::Fraction, "anteil"},
    {Role::Mass, "gewicht"},
    {Role::Tare, "leer"},
    {Role::And, "mit,und"},
    {Role::Soil, "boden"},
    {Role::Sample, "probe,entnahmestelle,schurf,bohrung"},
    {Role::Depth, "tiefe,teufe"},
    {Role::Number, "nr"},
    {Role::Filler, "als,in,der"},
    // Spanish
    {Role::Size, "diametro,abertura,tamano"},
    {Role::Sieve, "malla,tamiz,tamices"},
    {Role::Passing, "pasa,pasante,pasando"},
    {Role::Retained, "retenid"},
    {Role::Cumulative, "acumulad"},
    {Role::OnOne, "parcial"},
    {Role::Percent, "porcentaje"},
    {Role::Mass, "peso,masa"},
    {Role::Tare, "tara,vacio"},
    {Role::And, "con"},
    {Role::Soil, "suelo"},
    {Role::Sample, "muestra,calicata,cata,sondeo"},
    {Role::Depth, "profundidad"},
    {Role::Filler, "que,del,el"},
    // Portuguese, where it is not Spanish
    {Role::Sieve, "peneira"},
    {Role::Retained, "retid"},
    {Role::Passing, "passa"},
    {Role::Sample, "amostra,sondagem,furo"},
    // Italian
    {Role::Size, "apertura,maglia,dimensione,luce"},
    {Role::Sieve, "setaccio,vaglio,crivello"},
    {Role::Passing, "passante,passanti"},
    {Role::Retained, "trattenut,ritenut"},
    {Role::Cumulative, "cumulat,progressiv"},
    {Role::OnOne, "parziale,singolo"},
    {Role::Percent, "percentuale"},
    {Role::Mass, "massa"},
    {Role::Tare, "vuoto"},
    {Role::Soil, "terreno"},
    {Role::Sample, "campione,sondaggio"},
    {Role::Depth, "profondita"},
    {Role::Filler, "di,al,dei"},
});

constexpr auto share_units = std::to_array<Words<ShareUnit>>({
    {ShareUnit::Percent, "percent,pct"},
    {ShareUnit::Fraction, "-,1,fraction"},
    {ShareUnit::PerMille, "\u2030,g/kg,permille,promille,per mille"},
    {ShareUnit::Mass, "g,kg,gr,grams,gm,mg"},
});

constexpr auto size_scales = std::to_array<Words<SizeScale>>({
    {SizeScale::Millimeters, "mm,millimeter,millimeters,millimetre,millimetres,millimetri,milimetros"},
    {SizeScale::Micrometers, "um,micron,microns,micrometer,micrometers,micrometre,micrometres,mic,mu,mikron,mikrometer,"
                             "micras,micra,micrometri"},
    {SizeScale::Meters, "m,meter,meters,metre,metres"},
    {SizeScale::Centimeters, "cm"},
    {SizeScale::Inches, "in,inch,inches,\",zoll,pouce,pouces,pulgada,pulgadas,pulg,pollici"},
    {SizeScale::Phi, "phi,\u03c6,\u03d5,\u03a6,\u00f8,\u00d8"},
    {SizeScale::SieveNumber, "no,#,number,nr,mesh"},
});

constexpr auto results = std::to_array<Words<DerivedValue::Kind>>({
    {DerivedValue::Kind::Uniformity,
     "cu,u,uniformity,uniformite,ungleichformigkeitszahl,ungleichformigkeit,uniformidad,uniformita,hazen"},
    {DerivedValue::Kind::Curvature, "cc,cz,c,curvature,courbure,krummungszahl,curvatura"},
    {DerivedValue::Kind::Cobbles, "cobbles,boulders,cailloux,steine,bolos,ciottoli"},
    {DerivedValue::Kind::Gravel, "gravel,gravier,graviers,kies,grava,gravas,ghiaia"},
    {DerivedValue::Kind::Sand, "sand,sable,sables,arena,arenas,sabbia"},
    {DerivedValue::Kind::Fines, "fines,finos,fini,feinanteil"},
    {DerivedValue::Kind::Silt, "silt,limon,limons,schluff,limo"},
    {DerivedValue::Kind::Clay, "clay,argile,argiles,ton,arcilla,argilla"},
    {DerivedValue::Kind::Largest, "dmax,maximum"},
    {DerivedValue::Kind::Other,
     "coarse,medium,fine,fm,fineness,modulus,finura,finesse,ll,pl,pi,ip,liquid,plastic,plasticity,gs,gravity,uscs,"
     "aashto,classification,moisture,water,dmin,mean,median,sorting,skewness,kurtosis"},
    {DerivedValue::Kind::Loss, "loss,losses,lost,siebverlust,perte,pertes,perdida,perdidas,perdita,perdite"},
});

constexpr auto topics = std::to_array<Words<Topic>>({
    {Topic::Pan, "pan,receiver,bottom,fond,fondo,fundo,schale,boden,bodenschale,bodenblech,auffangschale,bandeja,ciego,"
                 "cazuela,rest,base,fondello"},
    {Topic::PanOrNote, "bottom,boden,rest,base"},
    {Topic::Total, "total,totals,sum,summe,somme,suma,totale,gesamt,somma,gesamtmasse"},
    {Topic::Loss,
     "loss,lost,wash,washed,washing,fines,perte,perdida,perdita,lavage,lavado,lavaggio,abgeschlammt,material"},
    {Topic::Washing, "wash ,washed ,washing ,lavage ,lavado ,lavaggio ,abschlammen ,abgeschlammt "},
    {Topic::Mass, "mass,masse,weight,wt ,poids,peso,massa,masa,einwaage,trockenmasse,gesamtmasse,trockengewicht"},
    {Topic::WholeSample,
     "dry,total,initial,sech,sec ,seco,seca,secca,secco,trocken,gesamt,specimen,sample,test ,einwaage,echantillon"},
    {Topic::OtherMass, "after,wash,wet ,moist,apres,lava,nach "
                       ",despues,dopo,humid,humed,umid,feucht,container,tare,tara,dish,moisture,water,sieve ,retained"},
    {Topic::Before, "before,avant ,vor ,antes ,prima "},
    {Topic::Drying, "drying,sechage,trocknen,trocknung,secado,secagem,essicc"},
    {Topic::Counted, "number ,count ,counts ,anzahl,nombre ,numero ,conteo ,q0 "},
    {Topic::NoDiameter, "radius ,radii ,rayon ,halbmesser,radio ,raggio ,log ,log10 ,lg ,ln "},
    {Topic::Index, "no,nr,num,number,numero,s,sl,sr,serial,index,idx,id,row,line,item,lfd,zeile,ligne,fila"},
    {Topic::Part, "table ,tabelle ,tableau ,tabla ,part ,teil ,partie ,page ,seite ,sheet ,blatt ,step ,fig"},
    {Topic::Hydrometer, "hydromet,sediment,areomet,araomet,schlamm,densimet,pipett"},
    {Topic::Units, "in,en,unit,units,unite,unites,einheit,einheiten,unidad,unidades,unita"},
    {Topic::TotalSample, "total ,totale ,gesamt ,whole "},
    {Topic::ResultFiller, "sieving,during,tamisage,tamizado,coefficient,coeff,coef,coefficiente,g,kg,of,de,di,d,der,"
                          "content,percent,percentage,pct,total,size,mm,um,m,value,the,"
                          "index,number,particle,grain,limit,specific,by,dry,mass,weight,fraction,f,and"},
    {Topic::AstmSieves, "astm,e11 ,us mesh,us sieve,us stand,us std,us series,usa stand,u s mesh,u s sieve,u s "
                        "stand,mesh us ,sieve us ,sieve no us "},
    {Topic::OtherSieves,
     "bs mesh,bs sieve,b s mesh,b s sieve,b s test,b s stand,bs no ,no bs ,tyler no ,no tyler,bs test,bs "
     "stand,bs410,bs 410,bs 1377,bss ,british mesh,british sieve,british stand,british "
     "test,mesh bs ,sieve bs ,sieves bs ,sieve no bs ,tyler mesh,tyler sieve,tyler screen,tyler stand,tyler "
     "series,mesh tyler,sieve tyler,sieves tyler,sieve no tyler"},
    {Topic::Mesh, "mesh"},
});

// What docs/gradings.md calls each meaning.
constexpr auto names_of_roles = std::to_array<Words<Role>>({
    {Role::Size, "heading: size"},
    {Role::Sieve, "heading: sieve"},
    {Role::Number, "heading: number of a sieve"},
    {Role::Phi, "heading: size in φ"},
    {Role::Passing, "heading: passing"},
    {Role::Retained, "heading: retained"},
    {Role::Coarser, "heading: coarser, cumulative"},
    {Role::Cumulative, "heading: cumulative"},
    {Role::OnOne, "heading: of one sieve alone"},
    {Role::Percent, "heading: percent"},
    {Role::Fraction, "heading: fraction"},
    {Role::Mass, "heading: mass"},
    {Role::Count, "heading: number of grains"},
    {Role::By, "heading: says that a share is by mass"},
    {Role::Tare, "heading: empty sieve"},
    {Role::And, "heading: sieve together with soil"},
    {Role::Gross, "heading: mass of sieve and soil"},
    {Role::Soil, "heading: soil"},
    {Role::Sample, "heading: name of a sample"},
    {Role::Depth, "heading: depth"},
    {Role::Filler, "heading: without meaning"},
});
constexpr auto names_of_size_scales = std::to_array<Words<SizeScale>>({
    {SizeScale::Millimeters, "unit: mm"},
    {SizeScale::Micrometers, "unit: µm"},
    {SizeScale::Meters, "unit: m"},
    {SizeScale::Centimeters, "unit: cm"},
    {SizeScale::Inches, "unit: inches"},
    {SizeScale::Phi, "unit: φ"},
    {SizeScale::SieveNumber, "unit: number of a sieve"},
});
constexpr auto names_of_share_units = std::to_array<Words<ShareUnit>>({
    {ShareUnit::Percent, "unit: percent (also `%`)"},
    {ShareUnit::Fraction, "unit: fraction"},
    {ShareUnit::PerMille, "unit: per mille"},
    {ShareUnit::Mass, "unit: mass"},
});
constexpr auto names_of_topics = std::to_array<Words<Topic>>({
    {Topic::Pan, "row: pan"},
    {Topic::Loss, "row: washed out, counted with the pan; the first word, next to one of washing"},
    {Topic::Washing, "row: word of washing"},
    {Topic::Total, "row: total"},
    {Topic::Hydrometer, "title: sedimentation"},
    {Topic::AstmSieves, "sieve numbers: those of ASTM E11"},
    {Topic::OtherSieves, "sieve numbers: of another standard, refused"},
});
constexpr auto names_of_results = std::to_array<Words<DerivedValue::Kind>>({
    {DerivedValue::Kind::Uniformity, "result: Cu"},
    {DerivedValue::Kind::Curvature, "result: Cc"},
    {DerivedValue::Kind::Cobbles, "result: cobbles"},
    {DerivedValue::Kind::Gravel, "result: gravel"},
    {DerivedValue::Kind::Sand, "result: sand"},
    {DerivedValue::Kind::Fines, "result: silt and clay"},
    {DerivedValue::Kind::Silt, "result: silt"},
    {DerivedValue::Kind::Clay, "result: clay"},
    {DerivedValue::Kind::Largest, "result: largest size"},
    {DerivedValue::Kind::Other, "result: not compared with the curve"},
    {DerivedValue::Kind::Loss, "result: sieving loss, left out"},
});

template <class Meaning, std::size_t N, std::size_t M>
void append_lists(
    const std::array<Words<Meaning>, N>& names, const std::array<Words<Meaning>, M>& rows, std::vector<WordList>& lists
) {
    for (const Words<Meaning>& name : names) {
        WordList& list = lists.emplace_back(WordList{name.words, {}});
        for (const Words<Meaning>& row : rows) {
            if (row.meaning == name.meaning) {
                any_word(row.words, [&list](std::string_view word) {
                    list.words.emplace_back(word.substr(0, word.find_last_not_of(' ') + 1));
                    return false;
                });
            }
        }
    }
}

constexpr auto prefixes = std::to_array<SizePrefix>({
    {"<=", SizeSense::Finer},
    {"\u2264", SizeSense::Finer},
    {"<", SizeSense::Finer},
    {">=", SizeSense::Coarser},
    {"\u2265", SizeSense::Coarser},
    {">", SizeSense::Coarser},
    {"passing ", SizeSense::Finer},
    {"pass ", SizeSense::Finer},
    {"finer than ", SizeSense::Finer},
    {"less than ", SizeSense::Finer},
    {"minus ", SizeSense::Finer},
    {"passant ", SizeSense::Finer},
    {"pasa ", SizeSense::Finer},
    {"passante ", SizeSense::Finer},
    {"retained on ", SizeSense::Coarser},
    {"coarser than ", SizeSense::Coarser},
    {"plus ", SizeSense::Coarser},
    {"-#", SizeSense::Finer},
    {"+#", SizeSense::Coarser},
});

constexpr auto marks_of_ranges =
    std::to_array<std::string_view>({" to ", " bis ", " \u00e0 ", " a ", "\u2013", "\u2014", "-"});

} // namespace

std::optional<Role> role_of(std::string_view word) {
    if (const auto role = meaning_of(roles, word)) {
        return role;
    }
    constexpr std::size_t whole = 5; // shorter ones are words of their own
    std::optional<Role> found;
    std::size_t longest = whole - 1;
    for (const Words<Role>& known : roles) {
        any_word(known.words, [&](std::string_view stem) {
            if (stem.size() > longest && word.find(stem) != std::string_view::npos) {
                found = known.meaning, longest = stem.size();
            }
            return false;
        });
    }
    return found;
}

ShareUnit share_unit_named(std::string_view unit) {
    return meaning_of(share_units, unit).value_or(ShareUnit::Unknown);
}

SizeScale size_scale_named(std::string_view unit) {
    return meaning_of(size_scales, unit).value_or(SizeScale::Unknown);
}

std::optional<DerivedValue::Kind> result_named(std::string_view word) {
    return meaning_of(results, word);
}

bool is_word_of(Topic topic, std::string_view word) {
    return std::ranges::any_of(topics, [&](const Words<Topic>& known) {
        return known.meaning == topic && any_word(known.words, [word](std::string_view one) { return one == word; });
    });
}

bool mentions(Topic topic, std::string_view words) {
    const auto begins_one = [words](std::string_view stem) {
        std::size_t at = words.find(stem);
        while (at != std::string_view::npos && (at == 0 || words[at - 1] != ' ')) {
            at = words.find(stem, at + 1);
        }
        return at != std::string_view::npos;
    };
    return std::ranges::any_of(topics, [&](const Words<Topic>& known) {
        return known.meaning == topic && any_word(known.words, begins_one);
    });
}

std::string in_small_letters(std::string_view text) {
    std::string small;
    for (const char c : text) {
        small += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return small;
}

std::vector<std::string_view> split_words(std::string_view text, std::string_view marks) {
    std::vector<std::string_view> words;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of(marks, begin), text.size());
        if (end > begin) {
            words.push_back(text.substr(begin, end - begin));
        }
        begin = end + 1;
    }
    return words;
}

std::span<const SizePrefix> size_prefixes() {
    return prefixes;
}

std::span<const std::string_view> range_marks() {
    return marks_of_ranges;
}

std::vector<WordList> word_lists() {
    std::vector<WordList> lists;
    append_lists(names_of_roles, roles, lists);
    append_lists(names_of_size_scales, size_scales, lists);
    append_lists(names_of_share_units, share_units, lists);
    append_lists(names_of_topics, topics, lists);
    append_lists(names_of_results, results, lists);
    return lists;
}

} // namespace suffuse::gradings
