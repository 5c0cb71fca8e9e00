# Texts of the page of a block, in Arabic; names, figures and order are those of the English texts, the terms those of docs/terms.md.

## engine

not-run = لم يُشغَّل: { $problem }
n- = {" "}({ $last })
not-done = لم يتم{ $what }: { $sentence }
not-oriented-yet = لم توجَّه بعد
looking-for-points-of-the = البحث عن نقاط الصورة المصححة
placing = وضع { $name }
placing-2 = الوضع
is-not-placed = لم توضع { $name }
laying-out-the-orthomosaic = تخطيط الموزاييك المصحح
orthomosaic = الموزاييك المصحح: { $name }
writing-the-orthomosaic = كتابة الموزاييك المصحح
placing-on-the-orthophoto = وضع { $name } على الصورة المصححة
adjusting-by-the-orthophoto = ضبط الكتلة بالصورة المصححة

## files

cameras = الكاميرات
ground-control-points = نقاط الضبط الأرضي
image-measurements = القياسات الصورية
image-positions = مواضع GNSS للصور
a-block-needs-two-images = تحتاج الكتلة إلى صورتين أو أكثر؛ أما الصورة المصححة فتكفيها صورة واحدة.
that-say-where-they-lie = { $taken } تذكر موضعها وتؤخذ صورًا فوتوغرافية: الصورة المصححة تعطى وحدها.
cancelled-what-was-placed-stays = أُلغي. ما وُضع باق.
nothing-was-placed = لم يوضع شيء: { $sentence }
more-than-two-images-are = أكثر من صورتين هي كتلة.
making-the-orthophoto-of-the = تُصنع الصورة المصححة للمشهد الاصطناعي …
the-orthophoto-could-not-be = تعذرت محاكاة الصورة المصححة
photos-of-a-simulated-block = { $files } من صور كتلة محاكاة. اضغط «تشغيل».
building-the-synthetic-scene = يُبنى المشهد الاصطناعي …
photographing-the-simulated-block-of = تُصوَّر الكتلة المحاكاة: { $count } من { $of } …
photograph-another-block = صوّر كتلة أخرى
the-block-could-not-be = تعذرت محاكاة الكتلة
from = { $texts } من { $name }.
from-2 = { $texts } من { $name }. { $problem }.
the-block-cannot-be-run = { $problem } لا يمكن تشغيل الكتلة به.
the-block-cannot-be-run-with = { $problem } لا يمكن تشغيل الكتلة بها.
open-the-other-project = افتح المشروع الآخر
the-former-block-stays-under = {" "}الكتلة السابقة باقية في المشاريع.
was-opened-the-file-does = فُتح { $name }. لا يحوي الملف صوره: أفلتها أيضًا لفتح الأزواج.{ $former }
a-run-needs-files = { $files ->
        [one] يحتاج التشغيل الجديد إلى ملف لا يحويه ملف المشروع: أعطه من جديد تحت «الملفات» في الإعدادات أو أزله هناك.
        [two] يحتاج التشغيل الجديد إلى ملفين لا يحويهما ملف المشروع: أعطهما من جديد تحت «الملفات» في الإعدادات أو أزلهما هناك.
        [few] يحتاج التشغيل الجديد إلى { $files } ملفات لا يحويها ملف المشروع: أعطها من جديد تحت «الملفات» في الإعدادات أو أزلها هناك.
       *[other] يحتاج التشغيل الجديد إلى { $files } ملفًا لا يحويها ملف المشروع: أعطها من جديد تحت «الملفات» في الإعدادات أو أزلها هناك.
    }
a-run-needs-its-orthophoto = يحتاج التشغيل الجديد إلى الصورة المصححة من جديد، ولا يحويها ملف المشروع: من دونها لا تقع الكتلة الجديدة عليها.
masks-are-not-in-the-file = { $masks ->
        [one] القناع { $name } ليس في ملف المشروع: أعطه من جديد، أو أزله لتشغيل الكتلة من دونه.
        [two] قناعان، أولهما { $name }، ليسا في ملف المشروع: أعطهما من جديد، أو أزلهما لتشغيل الكتلة من دونهما.
        [few] { $masks } أقنعة، منها { $name }، ليست في ملف المشروع: أعطها من جديد، أو أزلها لتشغيل الكتلة من دونها.
       *[other] { $masks } قناعًا، منها { $name }، ليست في ملف المشروع: أعطها من جديد، أو أزلها لتشغيل الكتلة من دونها.
    }
system-cannot-be-read = لا يمكن قراءته. المسموح: رمز EPSG (EPSG:25832) أو نص PROJ (+proj=utm +zone=32) أو WKT
geoid-is-not-in-the-file = الجيوئيد { $name } ليس في ملف المشروع: أعطه من جديد، أو أزله لتشغيل الكتلة من دونه.
keeping-the-pair = يُحفظ الزوج …
open-the-pair-of-the-block = افتح زوج الكتلة
keeping-the-edited-block = تُحفظ الكتلة المعدلة …
run-it-again = أعد التشغيل
the-former-block-stays-under-projects = { $text } الكتلة السابقة باقية في المشاريع.
remove-all-images = إزالة جميع الصور
project = المشروع
oriented-block = الكتلة الموجَّهة
what-was-set-up = ما أُعدّ
the-block-of-these-photos = العمل على هذه الصور
edited-block = الكتلة المعدلة
the-stays-under-projects = يبقى ذلك في المشاريع: { $what }.
what-was-placed-on-the = ما وُضع على الصورة المصححة
the-edit-by-hand-of = التعديل اليدوي لهذه الكتلة
the-edits-by-hand-of = التعديلات اليدوية لهذه الكتلة، وعددها { $length }،
in-the-block = { $sorted } في الكتلة.
skipped-their-names-are-in = تُخطّيت { $twice }: أسماؤها في الكتلة من قبل.
cameras-are-put-aside = { $problem } وُضع الملف جانبًا.
holds-no-cameras = { $problem } لا كاميرات فيه، فوُضع جانبًا.
is-no-table-of = نُحّي { $name } جانبًا، فليس نقاط ضبط أرضي ولا قياسات صورية ولا مواضع GNSS ولا علامات إطارية: { $why }
it-has-no-rows = لا صفوف فيه
its-values-stand-between-spaces = تفصل بين قيمه مسافات وليست name وx وy وz ولا image وpoint وx وy بالعدد نفسه في كل سطر؛ وتُقرأ الأسماء التي فيها مسافات إن فصلت الحقول فواصل أو فواصل منقوطة أو علامات جدولة
its-first-column-names-no-images = يجب أن يسمّي عموده الأول صورًا بلواحقها، مثل DSC_0001.JPG، وليس { $name } منها. أعمدة القياسات الصورية هي الصورة والنقطة وx وy بالبكسل، بهذا الترتيب
its-rows-are-images = صفوفه صور من نتيجة، لا نقاط ممسوحة ولا مواضع GNSS
its-rows-name-no-images = لا تسمي صفوفه صورًا: ليست { $name } من صور الكتلة، وليس لها لاحقة مثل DSC_0001.JPG
its-rows-are-tie-points = صفوفه نقاط ربط من نتيجة، لا نقاط ممسوحة
skipped-not-an-image-by = { $aside ->
        [one] تُخطّي ملف واحد
        [two] تُخطّي ملفان
        [few] تُخطّيت { $aside } ملفات
       *[other] تُخطّي { $aside } ملفًا
    }: ليس صورة بحسب اسمه.
press-place = اضغط «وضع».
press-run = اضغط «تشغيل».
open-the-setting = افتح “{ $label }”
press-frames = اضغط «{ $make }» تحت «فيلم ممسوح ضوئيًا» في إعدادات الصورة المصححة.
press-measure-marks = اضغط «{ $measure }» تحت «فيلم ممسوح ضوئيًا» في إعدادات الصورة المصححة، أو أعطِ جدول علامات إطارية لكل مسح ضوئي.
the-block-is-unchanged = { $what }: { $error }. لم تتغير الكتلة.
all-images-of-the-block = جميع صور الكتلة موجودة.
of-of-the-block-are = { $files } من { $size } من الكتلة موجودة.
metres = { $value } م
feet = { $value } قدم
skipped-a-project-has-one = تُخطّي { $more }: للمشروع صورة مصححة واحدة.
skipped-an-orthophoto-has-one = تُخطّي { $others }: للصورة المصححة نموذج ارتفاعات واحد.
reading-the-orthophoto = تجري قراءة الصورة المصححة { $name } …
cannot-be-used-as-an = لا يمكن استعمال { $name } صورة مصححة
is-a-grid-at-longitudes = { $name } شبكة أعداد عند خطوط طول وعرض، ووُضعت جانبًا. إن كانت جيوئيدًا فأعطها في الإعدادات بوصفها «الجيوئيد»؛ أما ارتفاعات الأرض فيجب أن تكون في نظام مسقط.
holds-heights-give-their-orthophoto = يحوي { $name } ارتفاعات: أعط صورتها المصححة أولًا، أو أعطهما معًا.
reading-the-heights = تجري قراءة الارتفاعات { $name } …
the-ground-is-level-at = الأرض مستوية عند { $name }.
heights-from-to = الارتفاعات من { $name }: { FIXED($from, digits: 1) } إلى { FIXED($to, digits: 1) } { $unit }.
cannot-be-used-as-heights = لا يمكن استعمال { $name } ارتفاعات
says-where-a-picture-of = يذكر { $name } موضع صورة بالاسم نفسه: أعطهما معًا.
placed-by = ، موضعها من { $name }
in-the-system-of = ، بنظام { $name }
epsg = ، EPSG:{ $epsg }
orthophoto-px-of = الصورة المصححة { $name }: { COUNT($width) } × { COUNT($height) } بكسل قدره { $gsd }{ $what }{ $by }.{ $degrees }
an-orthophoto-in-degrees = {" "}هي بالدرجات ({ $crs }): تُفرش تحت الخريطة، وتُعرض وحدها بنظام { $shown }{ $departs ->
        [none] {""}
       *[other] ، حيث يبلغ خطؤها { FIXED($departs, digits: 1) } بكسل على الأكثر
    }. لا توضع الصور إلا على صورة في نظام إسقاط: حوّل إسقاطها لذلك بالأمر gdalwarp -t_srs مثلًا.
the-work-that-was-done = {" "}ما أُنجز من العمل محفوظ: «تشغيل» يتابع من هناك.
restored-from-this-browser = استُرجع من هذا المتصفح: { $title_of }.{ $goes_on }
the-finished-block-is-damaged = الكتلة المنجزة تالفة
edits-of-former-blocks-are-left-out = تُركت تعديلات الكتل السابقة لهذه: { $error }.
the-image-is-damaged = الصورة { $name } تالفة
taking-the-block-off-the = تُفتح الكتلة كما كانت دون الصورة المصححة …
the-block-stays-as-it = تبقى الكتلة كما كانت: { $sentence }
a-block-is-placed-by = توضع الكتلة بصورها، ولا صورة منها موجودة: أفلتها.
cancelled-the-block-is-as = أُلغي: الكتلة كما كانت.

## mount

images-of-the-block = صور الكتلة
export-of-the-block = تصدير الكتلة
export-of-the-placed-images = تصدير الصور الموضوعة
edits = التعديلات
views-of-the-block = عروض الكتلة
settings-of-the-block = إعدادات الكتلة
images = صور …
images-cameras-or-project-of = صور كتلة أو كاميراتها أو مشروعها
image-files-a-cameras-file = ملفات صور؛ وملف كاميرات أو مشروع محفوظ أيضًا
folder = مجلد …
folder-of-images = مجلد صور
all-images-of-a-folder = جميع صور مجلد
simulated-block = كتلة محاكاة
photos-of-a-synthetic-scene = صور لمشهد اصطناعي تُولَّد في هذا اللسان
removes-all-images-an-edited = يزيل جميع الصور؛ والكتلة الموجَّهة أو المعدلة تبقى في المشاريع
the-files-of-these-images = ملفات هذه الصور غير مفتوحة: أفلتها وحاول من جديد.
the-pair-cannot-be-shown = لا يمكن عرض الزوج: { $error }.

## tables and edits

pairs = الأزواج
tie-points = نقاط الربط
observations = الأرصاد
control-and-check-points = نقاط الضبط والتحقق
tables = الجداول
of-what-is-chosen = للمختار
shows-the-observations-of-the = يعرض أرصاد النقاط المختارة أو الصورة المختارة أو الزوج المختار وحدها
table = الجدول: { $title }
height-of-the-tables = ارتفاع الجداول
points-2 = النقاط
observations-5 = الأرصاد
point-of-kind = { $kind ->
        [tie_point] نقطة الربط
        [ground_control] نقطة الضبط الأرضي
       *[manual] النقطة اليدوية
    } { $number }
take-what-is-chosen-out = يخرج المختار من الضبط (Delete)
reject-point = رفض النقطة
take-the-point-with-all = يخرج النقطة بجميع أرصادها (Shift+Delete)
use-what-is-chosen-again = يستعمل المختار من جديد (R)
remove-image = إزالة الصورة
take-the-chosen-image-out = يخرج ما اختير من الصور من الكتلة، ولا يحسب من جديد إلا ما يعتمد عليه
measure-it = قياس
measure-the-chosen-point-in = قياس النقطة المختارة في الصور المعروضة (E)
add-point = إضافة نقطة
measure-a-new-tie-point = قياس نقطة ربط جديدة في صورتين أو أكثر (A)
not-joined = لم تُضم: تبعد هذه النقاط بعضها عن بعض { $px } بكسل في { $image }، وللنقطة موضع واحد في الصورة. ارفض الرصد الخاطئ أولًا.
join = دمج
the-chosen-points-are-one = النقاط المختارة نقطة واحدة: تأخذ جميع أرصادها؛ وحيث لاثنتين رصدة في الصورة نفسها تُؤخذ رصدة النقطة ذات الأشعة الأكثر
split = فصل
the-point-is-two-one = النقطة اثنتان: واحدة للأرصاد في الصور المعروضة، وواحدة لسائرها. أغلق الصور التي تُظهر نقطة أخرى
match-it = مطابقة
match-the-point-in-the = مطابقة النقطة في الصور الأخرى بالمربعات الصغرى (F)
match-here = مطابقة هنا
match-the-point-here = مطابقة النقطة في الصورة النشطة وحدها، انطلاقًا من صورة أخرى معروضة، بالمربعات الصغرى (Shift+F)
the-point-is-measured-enter = تم قياس النقطة (Enter)
give-what-is-measured-up = ترك ما يقاس (Escape)
use-as = الاستعمال
control-point = نقطة ضبط
check-point = نقطة تحقق
not-used = غير مستعملة
new-point = نقطة جديدة
where-it-lies-is-not-known = {" "}{ $by ->
        [system] لا يُعرف أين تظهرها الصور: متى أُعطي نظام إحداثيات نقاط الضبط في الإعدادات فُتحت النقاط حيث تُتوقع.
       *[points] لا يُعرف أين تظهرها الصور: متى وُضعت في صورتين توقعت في الصور الأخرى حيث تتقاطع خطوطها القطبية.
    }
measured-points-are-not-in-it = { $points ->
        [one] نقطة مقيسة واحدة ليست
        [two] نقطتان مقيستان ليستا
        [few] { $points } نقاط مقيسة ليست
       *[other] { $points } نقطة مقيسة ليست
    } في الكتلة ولا في الملف: يحفظ هذا المتصفح قياساتها الصورية إلى أن يضمها تشغيل.
accepted-as-placed = قُبلت { $name } كما وُضعت في { $images ->
        [one] صورة واحدة
        [two] صورتين
        [few] { $images } صور
       *[other] { $images } صورة
    }؛ وزر ↶ يتراجع عن ذلك.
two-images-or-more-are = {" "}المطلوب صورتان أو أكثر.
placed-in-press-its-place = { $what }: وُضعت في { $placed ->
        [zero] لا صورة
        [one] صورة واحدة
        [two] صورتين
        [few] { $placed } صور
       *[other] { $placed } صورة
    }. اضغط موضعها في لوح، أو بالأسهم 0.1 بكسل، ومع Shift بكسلًا واحدًا؛ وEnter للوسط أو للموضع المتوقع.{ $more }
adjusting-the-block = تُضبط الكتلة …
n-0-px = ‏σ₀ من { $sigma0_px } إلى { $sigma0_px_2 } بكسل
rmse-px = ‏RMSE من { $rmse_px } إلى { $rmse_px_2 } بكسل
check-points-m = نقاط التحقق من { $checks_m } إلى { $checks_m_2 } م{ $of }
of-so-many-check-points = {" "}(عدد النقاط من { COUNT($points) } إلى { COUNT($points_2) })
images-oriented = الصور الموجَّهة من { COUNT($oriented) } إلى { COUNT($oriented_2) }
rejects-what-is-chosen-with = يرفض المختار؛ ومع Shift نقطته كلها
nothing-to-reject-is-chosen = لم يُختر ما يمكن رفضه
nothing-rejected-is-chosen = لم يُختر شيء مرفوض
needs-a-block = تلزم كتلة منجزة
no-plot-is-shown = لا يُعرض رسم بياني
needs-images = تلزم صور
no-chosen-image = لم تُختر صورة يمكن إخراجها
no-points-to-join = لم تُختر نقاط يمكن دمجها
no-point-to-split = لم تُختر نقطة يمكن فصلها
no-pair-is-chosen = لم يُختر زوج
no-link-is-chosen = لم يُختر رابط
needs-two-shown = تلزم صورتان معروضتان
needs-an-orthophoto = تلزم صورة مصححة
needs-marked-scans = تلزم كاميرا فيلم وعلامات إطارية للمسوح
no-point-is-chosen = لم تُختر نقطة
uses-what-is-chosen-again = يستعمل المختار من جديد
views-and-tables-of-a = عروض الكتلة وجداولها
choose-an-image-a-tie = اختر صورة أو زوجًا من الصور أو نقطة ربط أو رصدتها في الجدول أو الخريطة أو الصور، واضغط Delete لرفضها. في «الصور» يقيس E النقطة المختارة ويضيف A نقطة جديدة. تُضبط الكتلة من جديد بعد كل تعديل؛ والتراجع بلا حد.
edits-wait-for-the-run = التشغيل جار: عدّل كتلته بعد انتهائه.
history = السجل
as-found = كما وُجدت
restore-2 = استعادة { $name }
in = { $point } في { $image }
now = الآن
rmse-px-2 = ‏RMSE، بكسل
check-points-rmse-m = نقاط التحقق، RMSE، م
check-points-compared = نقاط التحقق
images-oriented-2 = الصور الموجَّهة
block-before-and-after-the = الكتلة قبل التعديل وبعده

## exports and flight

project-file = ملف المشروع
everything-zip = كل شيء (.zip)
bundler = Bundler
nvm-visualsfm = NVM (VisualSFM)
agisoft = Agisoft
csv-tables = جداول CSV
format = الصيغة
orthomosaic-geotiff = الموزاييك المصحح (GeoTIFF)
chosen-images-on-the-ground = الصور المختارة على الأرض (GeoTIFF)
choose-one-or-more-images = اختر صورة واحدة أو أكثر أولًا.
pixel-of-the-orthomosaic = ضلع بكسل الموزاييك المصحح بوحدات الكتلة؛ فارغ: ضلع بكسل الصور
pixel-as-the-images = البكسل: كالصور
writing = تجري كتابة { $names } …
cancelled-nothing-was-saved-the = أُلغي: لم يُحفظ شيء. لم تتغير الكتلة.
was-not-written = لم يُكتب { $names }: { $reason }.
photograph-this-block = صوّر هذه الكتلة
a-flight-in-strips-over = طيران في خطوط فوق مدينة مصطنعة. الصور الأكبر تستغرق أطول: 12 مليون بكسل بضع ثوان لكل صورة.

## images

press-a-point-every-image = اضغط نقطة: تُفتح عندها كل صورة تُظهرها. السحب للتحريك · العجلة و+ − للتكبير · 0 الصور كاملة · 1 بكسل ببكسل · الأسهم للتحريك · N P للنقاط · O اللوح التالي · Page Down وPage Up للصور · L الربط · M العدسة · U حيث لم تُقس · Escape لا شيء مختار. التعديلات: Delete يرفض، R يستعيد · E يقيس النقطة، A نقطة جديدة: الأسهم تحرك 0.1 بكسل، Enter يقبل، F يطابق.
images-of-the-block-2 = صور الكتلة
images-side-by-side-with = الصور جنبًا إلى جنب مع نقاط ربطها
add-images = إضافة صور …
close = إغلاق { $own }
the-file-of-this-image = ملف هذه الصورة غير مفتوح: لا يحوي المشروع صوره.
this-image-cannot-be-decoded = لا يمكن فك ترميز هذه الصورة.
the-place-on-the-orthophoto = الموضع الذي يُقاس على الصورة المصححة، تحت علامة التقاطع
rejected-gross-error = مرفوضة: خطأ جسيم
rejected-behind-the-image = مرفوضة: خلف الصورة
rejected-its-point-has-too = مرفوضة: أشعة نقطتها قليلة
rejected-does-not-fit = مرفوضة: لا توافق
not-adjusted = غير مضبوطة
predicted-not-measured = متوقعة، لم تُقس
legend-of-marks = معنى العلامات
legend-measured-by-hand = مقيسة يدويًا
legend-residual = متبقي رصد
legend-residual-rejected = متبقي رصد مرفوض
legend-chosen = النقطة المختارة
legend-predicted = حيث يتوقعها الضبط
legend-placed = حيث وُضعت
legend-epipolar = خط قطبي
v-px = ‏v { FIXED($residual, digits: 2) } { FIXED($residual_2, digits: 2) } بكسل
mdb-px = ‏MDB { FIXED($mdb, digits: 1) } بكسل
point-by-hand = نقطة يدوية
tie-point = نقطة ربط
not-intersected = لم تتقاطع
rays-rejected = ، والمرفوضة { COUNT($rejected) }
shown = ، المعروض { COUNT($seen) }
rays = الأشعة: { COUNT($observations) }{ $what }
rmse-px-3 = ‏RMSE { FIXED($rmse_px, digits: 2) } بكسل
largest-w-in = أكبر w { FIXED($w, digits: 1) } في { $name }
not-measured-in-more = لم تُقس في { COUNT($elsewhere) } أخرى
px = { $name }: { FIXED($at, digits: 1) }، { FIXED($at_2, digits: 1) } بكسل
mm = { FIXED($mm, digits: 3) }، { FIXED($mm_2, digits: 3) } مم
ground-about = الأرض نحو { $join }
show-the-observations-of-tie = إظهار أرصاد نقاط الربط
pan-and-zoom-all-images = تحريك جميع الصور وتكبيرها معًا (L)
loupe = العدسة
enlarge-what-is-under-the = تكبير ما تحت المؤشر في جميع الصور (M)
unmeasured = غير المقيسة
show-a-chosen-point-where = إظهار النقطة المختارة حيث لم تُقس أيضًا (U)
image = صورة …
other-images = صور أخرى
other-images-title = عرض الصور التالية (Page Down)؛ تبقى الصور التي وُضعت فيها النقطة المقيسة
open-as-pair = فتح زوجًا
match-the-two-images-that = مطابقة الصورتين المعروضتين في عرض الأزواج

## map

oriented-positions-from-above = المواضع الموجَّهة من أعلى
gnss-positions-from-above = مواضع GNSS من أعلى
arranged-by-connections-positions-have = مرتبة بحسب الصلات: لا معنى للمواضع
metres-east-and-north-of = بالأمتار شرق المبدأ وشماله
system-of-the-control-points = نظام نقاط الضبط
system-of-the-orthophoto = نظام الصورة المصححة
the-blocks-own-system-without = نظام الكتلة نفسها، بلا مقياس ولا شمال
by-residual = بالمتبقي
by-rays = بالأشعة
by-height = بالارتفاع
not-shown = مخفية
press-an-image-a-point = اضغط صورة أو نقطة أو خطًا لاختياره؛ اضغط الزوج مرة أخرى أو Enter لفتحه. Shift مع السحب يختار نقاط الربط. السحب للتحريك · العجلة و+ − للتكبير · 0 ملاءمة · N P للصور · C أزواج صورة · الأسهم للتحريك.
map = الخريطة
map-of-the-block = خريطة الكتلة
images-and-tie-points-of = صور الكتلة ونقاط ربطها من أعلى
lines-between-connected-images-wider = خطوط بين الصور المتصلة، أعرض بعدد نقاطها المشتركة؛ والمتقطعة لأزواج مرفوضة يدويًا
photos = الصور
small-photos-where-they-have = صور صغيرة حيث تتسع المساحة
footprints = الآثار الأرضية
what-each-image-covers-of = ما تغطيه كل صورة من أرض مستوية على ارتفاع نقاطها
offsets = الفروق
gnss-positions-and-differences-of = مواضع GNSS وفروق نقاط الضبط الأرضي والتحقق، مرسومة أطول مما هي
the-orthomosaic-of-the-block = الموزاييك المصحح للكتلة، تحت كل ما سواه
the-orthophoto-that-is-given = الصورة المصححة المعطاة، تحت كل ما سواها
lasso = التطويق
shift-and-a-drag-chooses = Shift مع السحب يختار نقاط الربط داخل محيط حر بدل مستطيل
orthomosaic-2 = الموزاييك المصحح
makes-a-quick-orthomosaic-of = يصنع موزاييكًا مصححًا سريعًا للكتلة ويضعه تحت الخريطة
common-points = النقاط المشتركة: { COUNT($most) }
matches = المطابقات: { COUNT($matches) }
widest-line = أعرض الخطوط: { $widest }.
the-orthomosaic-is-of-an = {" "}الموزاييك المصحح من تشغيل سابق.
the-orthophoto-is-in-another = {" "}الصورة المصححة في نظام آخر: ضع الكتلة أو صورًا منها عليها فتقع تحتها.
orthophoto-laid-under-by-positions = {" "}فُرشت الصورة المصححة تحتها بحسب موضعيهما على الأرض ({ $crs }{ $departs ->
        [none] {""}
       *[other] ؛ بخطأ يبلغ { FIXED($departs, digits: 1) } بكسل على الأكثر
    }).
the-orthophoto-is-not-laid-under = {" "}لم تُفرش الصورة المصححة تحت الكتلة: { $reason }
the-block-is-outside-the-system = {" "}لم تُفرش الصورة المصححة تحت الكتلة: تقع الكتلة خارج نظامها ({ $crs }).
the-orthophoto-lies-elsewhere = {" "}تقع الصورة المصححة في مكان غير مكان الكتلة ({ $crs }): أعط صورة للأرض نفسها.
orthophoto-laid-under-by-placed = {" "}فُرشت الصورة المصححة تحتها بعدد { $images ->
        [one] صورة واحدة موضوعة عليها
        [two] صورتين موضوعتين عليها
       *[other] { COUNT($images) } من الصور الموضوعة عليها
    }.
images-oriented-connected-pairs = { $view } الصور: { COUNT($images) }، الموجَّهة: { COUNT($oriented) }، الأزواج المتصلة: { COUNT($connected) }
and-rejected-by-hand = {" "}و{ COUNT($gone) } مرفوضة يدويًا
tie-points-from-to = نقاط الربط: { COUNT($taking) }{ $what }؛ { $title } من { $from } إلى { $to } { $unit }
ground-sample-distance = وسيط مسافة العينة الأرضية { $gsd }
gsd = مسافة العينة الأرضية { $gsd }
gnss-positions-differ-by-up = تختلف مواضع GNSS حتى { $gnss }
surveyed-points-differ-by-up = تختلف نقاط الضبط الأرضي والتحقق، وعددها { COUNT($surveyed) }، حتى { $surveyed_2 }
in-plan-and-height = { $plan } أفقيًا{ $height ->
        [none] {""}
       *[other] ، و{ $height } ارتفاعًا
    }
the-images-lie-within-by = تقع الصور ضمن { $length_text } في { $length_text_2 }
length-in-units-of-the-block = { $length } من وحدات الكتلة
matrix = المصفوفة
matrix-of-matches = مصفوفة المطابقات
images-by-images-arrow-keys = الصور مقابل الصور؛ تختار مفاتيح الأسهم زوجًا
press-a-cell-to-choose = اضغط خلية لاختيار زوجها؛ اضغطها مرة أخرى أو Enter لفتح الزوج. السحب للتحريك · العجلة و+ − للتكبير · 0 ملاءمة · الأسهم تختار.
strongest-cell-matches-small-square = أقوى خلية: { COUNT($view) } من المطابقات. المربع الصغير: غير متصل. المجوف: مرفوض يدويًا. الفارغ: لم يُجرَّب.
back-to-the-block = → العودة إلى الكتلة
use-masks-in-the-block = استعمال الأقنعة في الكتلة
what-they-mask-holds-no = ما تحجبه لا يحمل نقاطًا في الكتلة أيضًا، من تشغيلها التالي
masks-are-of-the-block = أقنعة { $names } هي أقنعة الكتلة الآن.
block-has-no-mask-of = لم يعد في الكتلة قناع للصور: { $names }.
marks-of-this-scan = علامات { $name }
use-marks-in-the-block = استعمال العلامات في الكتلة
the-tables-of-marks-become = تصير العلامات المقيسة جداول علامات هذه المسوح، محل ما لها
next-scans = المسوح التالية
next-scans-help = المسح التالي أو المسحان التاليان بلا علامات؛ وحين تكون لها جميعًا علامات، واحدًا بعد الآخر من جديد
# $worst: the mark that fits worst; 0 where none stands out.
marks-far-off = { $name }: قيمة σ₀ لعلاماته { FIXED($px, digits: 1) } بكسل من المسح؛ { $worst ->
        [0] إحداها مقيسة خطأ، أو كُتب x وy لها خطأ: راجع كلًّا منها.
       *[other] العلامة { COUNT($worst) } أسوؤها ملاءمة: قسها من جديد، أو صحّح x وy لها.
    }
marks-of-more-far-off = { $scans ->
        [one] وعلامات مسح آخر بعيدة أيضًا.
        [two] وعلامات مسحين آخرين بعيدة أيضًا.
        [few] وعلامات { $scans } مسوح أخرى بعيدة أيضًا.
       *[other] وعلامات { COUNT($scans) } مسحًا آخر بعيدة أيضًا.
    }
marks-without-mm = { $name }: علامات بلا x وy بالمليمتر: { COUNT($marks) }؛ اكتبها تحت «الكاميرا» في الإعدادات.
reject-matches-in-the-block = رفض { $matches ->
        [one] مطابقة واحدة
        [two] مطابقتين
        [few] { COUNT($matches) } مطابقات
       *[other] { COUNT($matches) } مطابقة
    } في الكتلة أيضًا
rejects-their-observations = يرفض رصدتي كل نقطة ربط جمعتها هذه المطابقات، في خطوة واحدة من تعديلات الكتلة، والتراجع عنها هناك
measured-matches-into-the-block = أخذ { $matches ->
        [one] مطابقة مقيسة واحدة
        [two] مطابقتين مقيستين
        [few] { COUNT($matches) } مطابقات مقيسة
       *[other] { COUNT($matches) } مطابقة مقيسة
    } إلى الكتلة
they-become-tie-points = يصير ما قيس يدويًا نقاط ربط في الكتلة، والمطابقة التي نُقلت تنقل رصدتي نقطة ربطها، في خطوة واحدة من تعديلات الكتلة
rejected-without-tie-point = مرفوضة هنا بلا نقطة ربط في الكتلة: { COUNT($without) } من { COUNT($rejected) }.
edit-and-figures = في الكتلة: { $edit }؛ { $figures }.
pairs-of-the-block-open-here = تُفتح هنا أزواج الكتلة أيضًا: { $names } أكثرها مطابقات؛ وتُختار الأخرى من خريطة الكتلة أو مصفوفتها أو جدولها.
was-saved-2 = حُفظ { $name }.{ $store }
noted = ملاحظة: { $remark }
laying-the-orthomosaic-under-the = يُفرش الموزاييك المصحح تحت الخريطة …
the-orthomosaic-lies-under-the = يقع الموزاييك المصحح تحت الخريطة. { $orthophoto }{ $store }
the-orthomosaic-cannot-be-shown = لا يمكن عرض الموزاييك المصحح: { $sentence }
an-orthomosaic-is-made-of = يُصنع الموزاييك المصحح من صور الكتلة، وليس منها شيء هنا: أفلتها.
cancelled-no-orthomosaic-was-made = أُلغي: لم يُصنع موزاييك مصحح.
no-orthomosaic-was-made = لم يُصنع موزاييك مصحح: { $sentence }
missing-in-it-add-to = {" "}تنقصه { $missing ->
        [one] صورة واحدة: أضفها
        [two] صورتان: أضفهما
        [few] { COUNT($missing) } صور: أضفها
       *[other] { COUNT($missing) } صورة: أضفها
    } إلى المشروع.

## orthophoto

role-picture = صورة
press-a-footprint-to-see = اضغط أثرًا أرضيًا لترى صورته بجانب الصورة المصححة، أو رابطًا لتراه في كلتيهما؛ وفي كتلة عليها أثرًا أو موضعًا لتختاره. السحب للتحريك · العجلة و+ − للتكبير · 0 ملاءمة · الأسهم للتحريك · N P للروابط أو المواضع · Page Down وPage Up للصور · Escape لا شيء مختار. الروابط اليدوية: Delete يرفض، R يستعمل من جديد، A يقيس رابطًا جديدًا، Enter يقبل.
orthophoto-with-the-images-that = الصورة المصححة مع الصور الموضوعة عليها
the-chosen-image-with-its = الصورة المختارة مع روابطها
column-row = العمود { FIXED($place, digits: 1) }  الصف { FIXED($place_2, digits: 1) }
press-the-place-on-the-orthophoto = موضع جديد: اضغطه على الصورة المصححة، أو حرّكها حتى يقع تحت علامة التقاطع واضغط Enter. ثم تُفتح الصور التي تُظهره.
places-by-hand-wait = { $places ->
        [one] موضع واحد مقيس يدويًا
        [two] موضعان مقيسان يدويًا
        [few] { $places } مواضع مقيسة يدويًا
       *[other] { $places } موضعًا مقيسًا يدويًا
    }، وعدد المقيس منها في صورتين أو أكثر { $measured }: ثلاثة تتوافق قياساتها تنقل الكتلة إلى نظام الصورة المصححة.
press-the-orthophoto-where-images = اضغط الصورة المصححة حيث التُقطت الصور.
a-block-that-is-placed = تُظهر الخريطة الكتلة على الصورة المصححة.
press-a-footprint-or-a = اضغط أثرًا أرضيًا أو صفًا من الجدول لترى روابطه.
a-new-link-press-the = رابط جديد: اضغط النقطة نفسها في الصورة وفي الصورة المصححة.
press-the-point-in-the = اضغط النقطة في الصورة.
press-the-point-on-the = اضغط النقطة في الصورة المصححة.
press-again-to-move-an = اضغط مرة أخرى لنقل طرف؛ Enter أو «قبول» يأخذ الرابط.
adjusting = يجري الضبط …
of-at-least-links-by = { $name }: { COUNT($added) } من { COUNT($least_links) } على الأقل من الروابط اليدوية.
the-image-does-not-see = لا ترى الصورة موضعه
residual-px-px = المتبقي { FIXED($residual, digits: 2) }، { FIXED($residual_2, digits: 2) } بكسل ({ FIXED($hypot, digits: 2) } بكسل)
measured-by-hand-3 = ، مقيس يدويًا
link-of = الرابط { COUNT($link) } من { COUNT($count) }{ $what }، { $name }: { $off }؛{" "}
links = الروابط:{" "}
links-by-which-the-image = روابط وُجّهت بها الصورة
links-that-took-no-part = روابط لم تشارك وتتحقق من النتيجة
links-that-were-rejected-as = روابط رُفضت أخطاءً جسيمة
places-of-the-block = المواضع:{" "}
places-by-which-the-block = مواضع الأرض التي تقع بها الكتلة في نظام الصورة المصححة: نقاط ضبط
places-that-took-no-part = مواضع الأرض التي لم تشارك وتتحقق من النتيجة: نقاط تحقق
places-that-were-rejected = مواضع الأرض التي رُفضت يدويًا
chooses-the-next-place-of = يختار موضع الأرض التالي
chooses-the-previous-place-of = يختار موضع الأرض السابق
rough-place = موضع تقريبي
the-next-press-on-the = الضغطة التالية على الصورة المصححة تبيّن أين التُقطت الصور تقريبًا؛ ويُبحث عنها ضمن نصف القطر المضبوط
over-the-orthophoto = فوق الصورة المصححة
the-chosen-image-on-the = الصورة المختارة على الأرض فوق الصورة المصححة: اضغطه مرارًا وانظر هل تتصل الطرق
everywhere = في كل مكان
images-are-sought-on-the = يُبحث عن الصور في الصورة المصححة كلها
whole-orthophoto = الصورة المصححة كلها
no-image-is-chosen = لم تُختر صورة
reject-link = رفض الرابط
leaves-the-chosen-link-out = يستبعد الرابط المختار (Delete)
use-link = استعمال الرابط
lets-the-chosen-link-take = يشرك الرابط المختار (R)
add-link = إضافة رابط
add-place = إضافة موضع
measures-a-place-by-hand = يقيس موضعًا من الصورة المصححة يدويًا، ثم يضبط الكتلة نقطةَ ضبط (A)
measures-a-link-by-hand = يقيس رابطًا يدويًا في الصورة وفي الصورة المصححة (A)
takes-the-link-that-is = يأخذ الرابط المقيس (Enter)
undo-2 = تراجع: { $last }
redo-2 = إعادة: { $next }
open-an-orthophoto = افتح صورة مصححة …
try-a-sample = جرّب نموذجًا
photographs-placed-on-an-orthophoto = صور توضع على صورة مصححة
drop-an-orthophoto-and-photographs = أفلت صورة مصححة وصورًا للأرض نفسها في أي مكان من هذه الصفحة، صورة أو أكثر، من سنة أخرى أو مائلة أو ممسوحة ضوئيًا. تحصل على:
where-each-was-taken-and = موضع التقاط كل صورة ودورانها في نظام الصورة المصححة، بلا نقطة ضبط
how-precise-that-is-and = دقة ذلك، وروابط لم تشارك وتتحقق منه
each-photograph-on-the-ground = كل صورة على الأرض بصيغة GeoTIFF
an-orthophoto-is-a-geotiff = الصورة المصححة ملف GeoTIFF في نظام إسقاط، أو صورة مع ملف إحداثيات (world file). تُفلت معها ارتفاعات أرضها بصيغة GeoTIFF أو شبكة ESRI ASCII؛ ودونها تكون الأرض مستوية.
links-3 = روابط
of = {" "}({ COUNT($total) } من { COUNT($total_2) })
open-an-orthophoto-photographs-are = افتح صورة مصححة: توضع عليها الصور دون نقاط ضبط.
open-photos = افتح صورًا …
can-be-placed = يمكن وضع { $files }. { $what }
place-on-the-orthophoto = وضع على الصورة المصححة
place-them-as-a-block = وضعها كتلةً
its-ground-is-taken-as = تُعد أرضها مستوية عند { FIXED($height, digits: 2) } { $unit }: أعط ارتفاعاتها حيث ليست كذلك.
they-lie-under-of-the = {" "}تقع تحت { $share } % من الصورة المصححة: لا يوضع شيء في غيرها.
heights-of-to =
    ارتفاعات { $name }: { FIXED($from, digits: 1) } إلى { FIXED($to, digits: 1) } { $unit }{ $given_in ->
        [none] {""}
       *[other] ، محوّلة من { $given_in } كما يقول ملفها
    }.{ $from_what ->
        [none] {""}
       *[other] {" "}وتُعدّ من { $from_what }.
    }{ $part }
with-doubt =
    { $of ->
        [one] ، مع شك
        [all] ، كلها مع شك
       *[some] ، منها { COUNT($weak) } مع شك
    }
not-placed = ، ولم توضع { COUNT($without) }
reason-of = { $name }: { $reason }
of-placed = وُضعت { COUNT($placed) } من { $tried }{ $what }{ $what_2 }.
then = ذلك
placed = وضع { $stale }{ $stale_2 ->
       *[other] {""}
    }
settings-heights-or-cameras-have = تغيرت الإعدادات أو الارتفاعات أو الكاميرات منذ { $what }: اضغط «وضع».
not-tried-yet-press-place = لم تُجرَّب { $waiting } بعد: اضغط «وضع».
save-positions-csv = حفظ المواضع (CSV)
open-heights = فتح ارتفاعات …
place-them = وضع
of-2 = { COUNT($placements) } من { COUNT($tried) }
images-placed = صور وُضعت
rmse-of-check-links-on = ‏RMSE لروابط التحقق على الأرض
positions-placed-csv = المواضع (placed.csv)
links-links-csv = الروابط (links.csv)
all-results-result-json = جميع النتائج (result.json)
chosen-image-on-the-ground = الصورة المختارة على الأرض (GeoTIFF)
all-images-on-the-ground = جميع الصور على الأرض (.zip)
what-of-the-placed-images = ما يُحفظ من الصور الموضوعة
cancelled-nothing-was-saved = أُلغي: لم يُحفظ شيء.
nothing-was-saved = لم يُحفظ شيء: { $sentence }
no-image-is-chosen-2 = لم تُختر صورة
resampling-to-the-ground-of = إعادة تعيين { $name } على الأرض ({ $i } من { $placed }) …
scanned-film = فيلم ممسوح ضوئيًا
film-camera = كاميرا الفيلم
marks-of-scans = العلامات الإطارية للمسوح الضوئية
none-film-camera = لا كاميرا فيلم. الكاميرا المعايرة لصور الفيلم الممسوحة ضوئيًا، ملف JSON: { $example }.
none-marks-of-scans = لا علامات إطارية. جدول col وrow وx_mm وy_mm لكل مسح ضوئي، باسم صورته: { $example } للصورة { $image }.
marks-of-no-image = لا تحمل أي صورة اسم { $name }: تُسمى العلامات الإطارية باسم صورة مسحها.
measure-marks = قياس العلامات
measure-marks-help = يفتح المسوح التي بلا علامات إطارية، اثنين في كل مرة، في عرض الأزواج، حيث تُضغط علاماتها في الصور
marks-of-some-scans = مسوح لها علامات: { COUNT($measured) } من { COUNT($scans) }.
make-frames = تحويل إلى صور كاميرا واحدة
make-frames-help = من أجل كتلة: يعيد معاينة كل مسح ضوئي بعلاماته الإطارية إلى صورة كاميرا مثالية، واحدة لها جميعًا وبلا تشوه. تحل هذه الصور محل المسوح، مع أقنعة للعلامات وملف كاميرتها. وتنتقل معها أقنعة المسوح والقياسات الصورية التي أُجريت فيها ومواقع GNSS الخاصة بها.
resampling-scan = إعادة معاينة { $name }
two-scans-of-one-name = { $name } ومسح آخر يصيران صورتين باسم واحد: غيِّر اسم أحدهما.
frame-is-there = { $name }، وهي صورة مسح، موجودة بالفعل. لم يتغير شيء: أزل المسح أو تلك الصورة.
scans-became-frames =
    أُعيدت معاينة المسوح إلى صور كاميرا واحدة: { COUNT($frames) }. الكاميرا { $known ->
        [yes] تُعد معايرة
       *[no] تعايرها الكتلة ضمن ما تتركه معايرتها وأخطاء العلامات الإطارية مفتوحًا
    }. تستبعد الأقنعة العلامات الإطارية.
measurements-carried = نُقلت القياسات الصورية: { COUNT($moved) }.
measurements-beside-frames = قياسات صورية خارج صورة مسحها، التي تنتهي داخل العلامات الإطارية، تُركت ({ COUNT($count) }): { $listed }.
no-frames-were-made = لم تُصنع صور من المسوح: { $sentence }
camera-of-frames = كاميرا الفيلم
marks-need-their-camera = تحتاج العلامات الإطارية إلى كاميرا الفيلم مع بعدها البؤري بالمليمتر.
cannot-be-used-of-film = لا يمكن استعمال { $name }: { $problem }
none-a-geotiff-in-a = لا شيء. ملف GeoTIFF في نظام إسقاط، أو صورة مع ملف إحداثياتها (‎.tfw و.jgw و.pgw و.wld‎) وربما ملف نظامها (‎.prj‎): اخترها معًا.
none-the-ground-is-level = لا شيء: الأرض مستوية. ملف GeoTIFF للارتفاعات أو شبكة ESRI ASCII، بنظام الصورة المصححة ووحدتها.
orthophoto-2 = صورة مصححة …
file-orthophoto = الملف: الصورة المصححة
heights = ارتفاعات …
file-heights = الملف: الارتفاعات
remove = إزالة
remove-orthophoto = إزالة: الصورة المصححة
from-to = { $name }: { FIXED($from, digits: 1) } إلى { FIXED($to, digits: 1) } { $unit }.
level-ground-at = أرض مستوية عند
level-of-block = ارتفاعها وسيط نقاط الربط في الكتلة: { $height }.
what-is-done-with-it = استعمالها
purpose-block = الكتلة
purpose-images = كل صورة
purpose-map = الخريطة
placed-images = الصور الموضوعة
links-2 = الروابط
table-placed-images = الجدول: الصور الموضوعة
links-of-the-chosen-image = روابط الصورة المختارة
table-links-of-the-chosen = الجدول: روابط الصورة المختارة
not-read = لم تُقرأ: { $problem }

## plots and progress

role-plot = مخطط
press-a-value-to-choose = اضغط قيمة لتختار ما تخصه؛ Shift مع السحب يختار كل ما في مستطيل. السحب للتحريك · العجلة و+ − للتكبير · 0 المخطط كله · Escape لا شيء مختار.
plots = المخططات
plot-of-the-block = مخطط الكتلة
plot = المخطط
saves-the-plot-as-it = يحفظ المخطط كما يُعرض، صورةً
saves-the-values-of-the = يحفظ قيم المخطط
this-block-has-none = لا قيم كهذه: ليس في هذه الكتلة شيء منها.
there-are-no-such-values = لا قيم كهذه: ليس في هذه الكتلة شيء منها، أو لم توجَّه بعد.
n--2 = {" "}{ $unit }
axis-title = { $label }، { $unit }
values-over-median-from-to = عدد القيم { COUNT($sorted) } مقابل { $to_lower_case }. { $label }: الوسيط { $at }، من { $at_2 } إلى { $at_3 }{ $what }.
unchecked-at-the-top = وفي الأعلى { COUNT($unchecked) } { $unchecked ->
        [one] أخرى
       *[other] غيرها
    }: لا شيء يتحقق من إحدى الإحداثيتين.
seconds = { $value } ث
hours = { $value } س
images-features = الصور: السمات
similarity-of-images = تشابه الصور
pairs-matches = الأزواج: المطابقات
windows-of-observations = نوافذ الأرصاد
refinement = التدقيق
from-an-earlier-run = ، منها { COUNT($found) } من تشغيل سابق
of-3 = { COUNT($done) } من { COUNT($total) }{ $what }
about-left = ، بقي نحو { $seconds_left }
starting = يبدأ …
min = { $minutes } د

## results

one-group = واحدة
unknown-2 = مجهول
no-block-yet-drop-images = لا كتلة بعد. أفلت صورًا أو مجلدًا، أو حاكِ كتلة، ثم اضغط «تشغيل».
so-far = حتى الآن
masks-without-an-image = أقنعة بلا صورة
no-image-has-their-name = لا صورة باسمها
image-measurements-without-an-image = قياسات صورية بلا صورة
not-among-the-images-read = ليست من الصور المقروءة
remarks = ملاحظات
warnings = تحذيرات
tie-points-by-number-of = النقاط بعدد الأشعة
images-read = الصور المقروءة
images-whose-features-are-detected = الصور التي كُشفت سماتها.
connected-pairs = الأزواج المتصلة
of-tried = { COUNT($connected) } من { COUNT($connections) } مجرَّبة
pairs-with-enough-matches-that = أزواج لها ما يكفي من المطابقات المتفقة على هندسة واحدة.
verified-matches-of-all-connected = المطابقات المتحقق منها لجميع الأزواج المتصلة.
check-points-rmse = نقاط التحقق، RMSE
predicted = ، { FIXED($ratio, digits: 2) } من الأخطاء المعيارية المتوقعة
m-points = { $join } م، عدد النقاط { COUNT($points) }{ $what }
root-mean-square-difference-of = الجذر التربيعي لمتوسط مربعات فروق x وy وz بين نقاط التحقق المضبوطة والممسوحة التي لم تشارك إحداثياتها (وشاركت قياساتها الصورية كقياسات نقاط الربط)، بالأمتار على محاور نظام إحداثيات النتائج؛ ثم الشيء نفسه مقسومًا على الأخطاء المعيارية المتوقعة، نحو 1 حيث تصح.
check-points-mean = نقاط التحقق، المتوسط
mean-m = { $join } م
mean-difference-of-check-points = متوسط فروق x وy وz بين إحداثيات نقاط التحقق المضبوطة والمعطاة، بالأمتار على محاور نظام إحداثيات النتائج. المتوسط الكبير مقارنة بالجذر التربيعي لمتوسط المربعات إزاحة تشترك فيها كلها.
images-oriented-3 = الصور الموجَّهة
of-4 = { COUNT($oriented) } من { COUNT($images) }
images-with-an-exterior-orientation = الصور ذات التوجيه الخارجي: الموضع والوضعية في فضاء الجسم.
pairs-with-enough-matches-that-agree = أزواج لها ما يكفي من المطابقات المتفقة على هندسة واحدة. تذكر المصفوفة لكل زوج سبب اتصاله أو عدمه.
groups = المجموعات
images-that-are-connected-directly = صور متصلة مباشرة أو عبر غيرها. لا توجَّه الصور بعضها بالنسبة إلى بعض إلا داخل مجموعة.
observations-2 = { COUNT($points) }، الأرصاد: { COUNT($rays) }
points-seen-in-two-or = نقاط تُرى في صورتين أو أكثر. يُضبط منها اختيار حسن التوزيع.
selected-tie-points = نقاط الربط المختارة
the-tie-points-of-the = نقاط ربط الكتلة المضبوطة وأرصادها الصورية، دون نقاط الضبط الأرضي والتحقق.
control-and-check-points-of-the = نقاط الضبط الأرضي والتحقق في الكتلة، وقياساتها الصورية دون المرفوضة.
root-mean-square-length-of = الجذر التربيعي لمتوسط مربعات أطوال متبقيات جميع الأرصاد المقبولة بعد الضبط.
standard-error-of-one-image = الخطأ المعياري لإحداثي صورة واحد، من الضبط.
did-not-converge = لم تتقارب
at-the-border = عند الحد
moved-too-far = ابتعدت كثيرًا
low-correlation-2 = ارتباط ضعيف
no-texture = بلا نسيج
inconsistent = غير متسقة
refined-observations = الأرصاد المدققة
of-5 = { COUNT($refined) } من { COUNT($refined_2) }
n--3 = : { $join }
observations-moved-by-least-squares = أرصاد نقلتها المطابقة بالمربعات الصغرى إلى الأرصاد المرجعية لعدد { COUNT($reference) } من النقاط. وتبقى سائر الأرصاد في مواضعها{ $what }.
right-points = النقاط الصحيحة
of-6 = { COUNT($right_points) } من { COUNT($points) }
points-whose-observations-all-agree = نقاط تتفق أرصادها كلها ضمن 1.5 بكسل في كل صورة، بالتوجيهات الحقيقية.
their-observations = أرصادها
root-mean-square-distance-of = الجذر التربيعي لمتوسط مربعات أبعاد أرصاد النقاط الصحيحة عن تقاطعها.
positions = المواضع
root-mean-square-errors-of = الجذر التربيعي لمتوسط مربعات أخطاء x وy وz لمراكز الإسقاط بعد أفضل تحويل تشابه إلى الحقيقة.
angles = الزوايا
root-mean-square-angle-between = الجذر التربيعي لمتوسط مربعات الزوايا بين الوضعيات الموجَّهة والحقيقية بعد التحويل نفسه.
single = ، ومنفردة { COUNT($alone) }
the-largest-of = { COUNT($sizes) } (الكبرى من { COUNT($largest) }){ $what }
other-files-skipped = ملفات أخرى متخطاة
no-images-by-their-names = ليست صورًا بحسب أسمائها
skipped-that-cannot-be-read = متخطاة: { COUNT($left_out) } لا يمكن استخدامها
take-these-out = أخرج هذه
not-oriented = غير موجَّهة: { COUNT($lost) }
and-more-in-the-table = و{ COUNT($rest) } أخرى في جدول الصور
rays-2 = الأشعة
rmse-px-4 = RMSE بكسل
given-f-px = f المعطى px
calibrated-f-px = f المعايَر px
stated-standard-errors = الأخطاء المعيارية المعطاة
by-residuals-stated = بالمتبقيات / المعطى
interval-of-95 = مجال 95 %
weights-by = الأوزان بحسب
weights-by-residuals = المتبقيات
weights-by-stated = الأخطاء المعيارية المعطاة
weights-by-stated-held = الأخطاء المعيارية المعطاة (مثبَّتة)
components-explained = الأخطاء المعيارية بحسب المتبقيات إلى جانب المعطاة. إن زاد العامل على 1 فقد أُعطيت أصغر مما هي. وحيث يحوي المجال 1 لا تناقضها المتبقيات.

## settings

use-gnss-positions = استعمال مواضع GNSS
they-choose-near-pairs-and = تختار الأزواج المتقاربة وتُسند الكتلة جغرافيًا.
wait-for-run = انتظار «تشغيل»
images-that-are-given-wait = تنتظر الصور المعطاة حتى يُضغط «تشغيل»، فتسبقها الإعدادات والملفات. وإلا شُغّلت حالًا.
from-exif-a-json-file = من EXIF. يغلبها ملف JSON: { $example }، مع principal_point_px وradial وtangential وfixed حيث تُعرف.
none-two-files-georeference-the = لا شيء. تُسند نقاط الضبط الأرضي (الاسم، x، y، z، واختيارًا خطآن معياريان) الكتلة جغرافيًا مع قياساتها الصورية (الصورة، النقطة، العمود، الصف)، واحد في كل سطر. من دون ملف للقياسات، قِس النقاط في الصور.
none-positions-of-images = لا شيء. تحل مواضع GNSS للصور (الصورة، خط الطول، خط العرض، الارتفاع فوق المجسم الإهليلجي، أو x وy والارتفاع في نظام الإحداثيات المعطى أدناه، واختيارًا خطآن معياريان) محل المواضع المسجلة في ملفاتها. يسمي السطر الأول الأعمدة.
none-images-of-the-same = لا شيء. صور بالحجم نفسه، سوداء حيث لا تُكشف سمات؛ IMG_1.png أو IMG_1_mask.png أو IMG_1.jpg.png هو قناع IMG_1.jpg.
masks = الأقنعة
none-a-file-from-which = لا شيء. ملف تُحسب منه ارتفاعات نظام الإحداثيات: GeoTIFF بخطوط الطول والعرض، أو GTX، أو PGM من GeographicLib.
masks-2 = الأقنعة: { $given }: { $names }{ $what }
file = الملف: { $title }
remove-2 = إزالة: { $title }

## stage and status

whole-block = الكتلة كلها
view-of-the-block = عرض الكتلة
table-2 = الجدول
pair-and-its-block = الزوج وكتلته
open-this-pair = افتح هذا الزوج
point-at-an-image-a = أشر إلى صورة أو خط أو خلية لترى ما هي ولماذا لا يتصل زوج.
try-a-sample-orthophoto = جرّب صورة مصححة نموذجية
where-each-photo-was-taken = موضع التقاط كل صورة ودورانها
points-that-several-photos-show = نقاط تُظهرها عدة صور، في الفضاء، ودقتها
files-for-other-programs-colmap = ملفات لبرامج أخرى: COLMAP وMicMac وOpenSfM وAgisoft وغيرها
where-did-each-photo-stand = أين كانت كل صورة؟
drop-the-photographs-of-a = أفلت صور طيران أو صور جولة حول شيء، أو مجلدًا منها، في أي مكان من هذه الصفحة. تحصل على:
nothing-leaves-this-computer-work = لا شيء يغادر هذا الحاسوب. يُحفظ العمل في هذا المتصفح: ما أُلغي من تشغيل أو انتهى مع لسانه يُتابع من هناك.
are-placed-on-the-orthophoto =
    الموضوعة منها على الصورة المصححة، كلٌّ على حدة: { $placed }؛ انظر عرض الصورة المصححة. يعرضها هذا العرض بعد تشغيلها كتلةً.
images-3 = الصور: { $names }: { $join }{ $what }
go-on = متابعة
the-screen-shows-the-former = {" "}تعرض الشاشة الكتلة السابقة.
shown-and = معروض و
cancelled-the-work-done-is = أُلغي.{ $former } ما أُنجز من العمل { $what }محفوظ: «متابعة» تكمل من هناك.
the-work-done-is-kept = {" "}ما أُنجز من العمل محفوظ.
the-block-was-not-finished = لم تكتمل الكتلة: { $failure }{ $what }
images-or-settings-have-changed = تغيرت الصور أو الإعدادات: اضغط «تشغيل».
open-the-images-of-a = افتح صور كتلة: ملفات أو مجلدًا أو كتلة محاكاة.
tie-points-used = نقاط ربط مستعملة
rmse-of-check-points = { $points ->
    [one] نقطة تحقق واحدة، RMSE أفقيًا · ارتفاعًا
    [two] نقطتا تحقق، RMSE أفقيًا · ارتفاعًا
    [few] { COUNT($points) } نقاط تحقق، RMSE أفقيًا · ارتفاعًا
   *[other] { COUNT($points) } نقطة تحقق، RMSE أفقيًا · ارتفاعًا
}
median-errors-of-tie-points = نقاط الربط، وسيط σ أفقيًا · ارتفاعًا
plan-and-height-of = { $plan } · { $height } م
plan-and-height-m = { FIXED($plan, digits: 3) } · { FIXED($height, digits: 3) } م
control-places-the-block = تقع الكتلة حيث تضعها نقاط ضبطها. ويمكن وضعها على الصورة المصححة أيضًا.
a-block-on-an-orthophoto = يمكن وضع الكتلة عليها: تقع عندئذ في نظامها دون نقطة ضبط.
place-the-block-on-the = وضع الكتلة على الصورة المصححة
place-each-image = وضع كل صورة وحدها
only-under-the-map = تحت الخريطة فقط
not-now = ليس الآن
the-block-is-not-on = لم توضع الكتلة على الصورة المصححة بهذه الإعدادات.
places-found-hold-it-too = ويمكن أن تثبّتها أيضًا مواضع يُعثر عليها في الصورة المصححة.
without-the-orthophoto = دون الصورة المصححة
the-block-as-it-was = يعيد الكتلة كما كانت قبل وضعها على الصورة المصححة

## columns

oriented = موجَّهة
accepted = مقبولة
rejected-2 = مرفوضة
too-few-rays = مرفوضة: أشعة متلاقية أقل من اللازم
role = { $role ->
        [control] ضبط
       *[check] تحقق
    }
projection-centre-in-m-where = مركز الإسقاط، { $key }؛ بالمتر حيث للكتلة مقياس.
image-2 = الصورة
file-name-press-it-to = اسم الملف. اضغطه لاختيار الصورة في جميع العروض؛ ومع Shift أو Ctrl عدة صور.
no = الرقم
row-and-column-in-the = الصف والعمود في المصفوفة.
features = السمات
points-detected-and-described = النقاط المكشوفة والموصوفة.
obs = الأرصاد
observations-of-selected-tie-points = أرصاد نقاط الربط المختارة ونقاط الضبط الأرضي والتحقق، دون المرفوضة.
cov = التغطية
coverage-how-many-of-the = التغطية: كم من مواضع فون غروبر التسعة فيه نقطة ربط مختارة.
root-mean-square-length-of-the = الجذر التربيعي لمتوسط مربعات أطوال متبقيات أرصادها.
images-of-one-camera-are = تُعايَر صور الكاميرا الواحدة معًا: { $join }.
state = الحالة
whether-the-image-is-oriented = هل الصورة موجَّهة، وإلا فالسبب.
the-image-of-the-pair = صورة الزوج الأولى. اضغط صفًا لاختيار زوجه في جميع العروض.
with = مع
the-other-image-of-the = الصورة الأخرى في الزوج.
verified-matches-of-a-connected = المطابقات المتحقق منها لزوج متصل.
common = المشتركة
tie-points-that-both-images = نقاط الربط التي تُظهرها الصورتان.
selected = المختارة
of-them-those-that-were = ما اختير منها وأُبقي.
geometry-2 = الهندسة
what-relates-the-two-views = ما يصل المشهدين، مع الخطأ المعياري للإحداثي.
outcome = النتيجة
why-the-images-are-connected = سبب اتصال الصورتين أو عدمه.
object-coordinate-in-m-where = إحداثي الجسم، بالمتر حيث للكتلة مقياس.
standard-error-of-from-the = الخطأ المعياري لـ{ $label }، من الضبط.
number-of-the-point-press = رقم نقطة الربط، أو اسم نقطة الضبط الأرضي أو التحقق. اضغط صفًا لاختيارها في جميع العروض؛ ومع Shift أو Ctrl عدة نقاط.
observations-of-the-point = أرصاد النقطة دون المرفوضة.
kind = النوع
tie-point-2 = نقطة ربط
tie-point-or-control = هل هي نقطة ربط أم نقطة ضبط أرضي أم نقطة تحقق.
probability = الاحتمال
probability-that-all-its-observations = احتمال أن تُظهر أرصادها كلها نقطة واحدة، من المطابقات وحدها.
part = المشاركة
whether-the-point-takes-part = هل تشارك النقطة في الضبط.
name-of-the-surveyed-point = اسم نقطة الضبط الأرضي أو التحقق. اضغط صفًا لاختيارها في جميع العروض.
use = الاستعمال
control-points-place-the-block = نقاط الضبط تضع الكتلة؛ ونقاط التحقق تحكم عليها ولا تشارك.
image-measurements-that-took-part = القياسات الصورية التي شاركت.
surveyed-in-the-system-of = ‏{ $axis } الممسوح، في نظام الكتلة.
as-given = ‏{ $axis } كما أُعطي
in-system = { $axis } { $code }
coordinate-in-system = ‏{ $axis } في { $name }، النظام المرجعي لإحداثيات النتائج.
in-the-unit-and-the = ‏{ $axis } كما يعطيه الملف، بوحدته وفي نظامه.
adjusted-minus-surveyed = المضبوط ناقص الممسوح، { $axis }.
standard-error-of = الخطأ المعياري لـΔ{ $axis }‎.
difference-by-standard-error = فرق { $axis } مقسومًا على خطئه المعياري المتوقع؛ ولنقطة الضبط فرقها وهي مستبعدة حيث يُعرف. ما تجاوز 2 أكبر من المتوقع، وما تجاوز 3 نادرًا ما يكون مصادفة.
difference-left-out = ‏Δ{ $axis }‎ دونها
where-the-other-observations-have = لنقطة الضبط: { $axis } حيث تضعه الأرصاد الأخرى دون إحداثياتها هي، ناقص الممسوح: قيمتها لو كانت نقطة تحقق.
standard-error-left-out = ‏σ Δ{ $axis }‎ دونها
standard-error-of-where-the = الخطأ المعياري لـΔ{ $axis }‎ دون نقطة الضبط نفسها.
the-image-that-shows-the = الصورة التي تُظهر النقطة. اضغط صفًا لاختيار نقطته، كما تُظهرها هذه الصورة، في جميع العروض.
number-of-the-point = رقم نقطة الربط، أو اسم نقطة الضبط الأرضي أو التحقق.
column-the-centre-of-the = العمود؛ مركز البكسل الأيسر العلوي عند 0.5.
row = الصف.
residual-in-x-observed-minus = المتبقي في x: المرصود ناقص المحسوب.
residual-in-y-observed-minus = المتبقي في y: المرصود ناقص المحسوب.
residual = المتبقي
length-of-the-residual = طول المتبقي.
redundancy-number-of-an-observation = عدد الفائض لـ { $axis }، من 0 إلى 1: نصيب خطأ الإحداثي الذي يظهر في متبقيه. قرب 0 لا يراقبه شيء.
w-statistic-of-an-observation = الإحصاءة w لـ { $axis }: المتبقي مقسومًا على خطئه المعياري (Baarda). يرفض تقصّي البيانات أكبرها.
mdb-of-an-observation = أصغر انحياز يمكن كشفه (MDB) لـ { $axis }: يكشف اختبار الإحداثي خطأ بهذا القدر باحتمال 0.80. ويكبر كلما صغر عدد الفائض.
whether-the-adjustment-accepted-the = هل قبل الضبط الرصدة، وإلا فمن رفضها.
the-edit-was-not-made = لم يتم التعديل: { $reason } لم تتغير الكتلة.
image-measurements-need-their-ground = تحتاج القياسات الصورية إلى نقاط ضبطها الأرضي: أعط ملفها أيضًا
placed-2 = موضوعة
link-use = { $use ->
        [used] مستعمل
        [check] تحقق
       *[rejected] مرفوض
    }
with-doubt-2 = مع شك
not-placed-2 = لم توضع
not-read-2 = لم تُقرأ
file-name-press-a-row = اسم الملف. اضغط صفًا لترى الصورة بجانب الصورة المصححة.
verdict = الحكم
earlier-settings = {" "}(إعدادات سابقة)
what-the-place-of-the = قيمة موضع الصورة.
projection-centre-in-the-system = مركز الإسقاط، { $axis }، في نظام الصورة المصححة.
standard-error-of-2 = الخطأ المعياري لـ{ $axis }.
rotation = الدوران { $angle }.
standard-error-of-3 = الخطأ المعياري لـ{ $angle }.
points-of-the-image-and = نقاط الصورة ومواضعها في الصورة المصححة التي وُجّهت بها.
rejected = المرفوضة
links-rejected-as-gross-errors = الروابط المرفوضة أخطاءً جسيمة.
root-mean-square-length-of-the-residuals = الجذر التربيعي لمتوسط مربعات أطوال متبقيات روابطها.
checks = التحقق
links-that-took-no-part-and = روابط لم تشارك وتتحقق من النتيجة.
check-rmse = RMSE التحقق
root-mean-square-length-of-the-residuals-of = الجذر التربيعي لمتوسط مربعات أطوال متبقيات روابط التحقق، دون الأخطاء الجسيمة.
on-the-ground = على الأرض
the-same-on-the-ground = الشيء نفسه على الأرض.
ground-sample-distance-the-side = مسافة العينة الأرضية: ضلع بكسل الصورة على الأرض.
above-ground = فوق الأرض
height-of-the-projection-centre = ارتفاع مركز الإسقاط فوق الأرض.
why = السبب
the-verdict-in-a-sentence = الحكم في جملة.
link = الرابط
number-of-the-link-press = رقم الرابط. اضغط صفًا لتراه في الصورة وفي الصورة المصححة.
used-for-the-orientation-kept = مستعمل للتوجيه، أو مستبعد للتحقق منه، أو مرفوض يدويًا أو خطأً جسيمًا.
column = العمود
position-in-the-image-the = الموضع في الصورة؛ مركز البكسل الأيسر العلوي (0.5، 0.5).
row-2 = الصف
position-in-the-image = الموضع في الصورة.
place-on-the-orthophoto-2 = الموضع في الصورة المصححة.
height-of-the-ground-at = ارتفاع الأرض في ذلك الموضع.
residual-x = المتبقي x
observed-minus-computed-column = العمود المرصود ناقص المحسوب.
residual-y = المتبقي y
observed-minus-computed-row = الصف المرصود ناقص المحسوب.
length = الطول

## plots

residuals-by-image = المتبقيات بحسب الصورة
residuals-of-observations = متبقيات الأرصاد
w-against-the-normal-distribution = الإحصاءات w إزاء التوزيع الطبيعي
minimal-detectable-biases-by-image = أصغر انحياز يمكن كشفه بحسب الصورة
tie-points-by-rays = نقاط الربط بحسب الأشعة
standard-errors-in-plan-along = الأخطاء المعيارية الأفقية على امتداد الكتلة
standard-errors-in-height-along = الأخطاء المعيارية الارتفاعية على امتداد الكتلة
gnss-positions = مواضع GNSS
control-and-check-points-plan = نقاط الضبط والتحقق، أفقيًا
control-and-check-points-height = نقاط الضبط والتحقق، ارتفاعًا
rmse-of-the-residuals = ‏RMSE المتبقيات
gnss-minus-adjusted-position = موضع GNSS ناقص المضبوط
standard-error-in-plan = الخطأ المعياري الأفقي
standard-error-in-height = الخطأ المعياري الارتفاعي
adjusted-minus-surveyed-place = الموضع المضبوط ناقص الممسوح
adjusted-minus-surveyed-height = الارتفاع المضبوط ناقص الممسوح
control-point-left-out = نقطة ضبط مستبعدة
control-point-adjusted = نقطة ضبط مشاركة في الضبط
whiskers-of-95 = ± 1.96 خطأ معياري
surveyed-value = { $name }، { $kind }: { FIXED($difference, digits: 3) }{ $known ->
    [yes] {" "}م، σ { FIXED($error, digits: 3) } م، Δ/σ { FIXED($ratio, digits: 1) }
   *[no] {" "}م
}
residual-vx = المتبقي vx
residual-vy = المتبقي vy
w-of-normal-errors = ‏w لأخطاء موزعة توزيعًا طبيعيًا
w-statistic = الإحصاءة w
image-coordinate = الإحداثي
minimal-detectable-bias = أصغر انحياز يمكن كشفه

## state

by-hand-kept = { $edits ->
        [one] بقي تعديل يدوي واحد.
        [two] بقي تعديلان يدويان.
        [few] بقيت { $edits } تعديلات يدوية.
       *[other] بقي { $edits } تعديلًا يدويًا.
    }
edits-of-places = { $lost ->
        [0] يبقى ما عُمل بمواضع الصورة المصححة ساريًا حيث تقع من جديد، وعددها { $held }.
       *[other] يبقى ما عُمل بمواضع الصورة المصححة ساريًا حيث تقع من جديد، وعددها { $held }، ولا يسري على { $lost } منها: لم يُعثر هناك على شيء، أو أن ما قيس يخص موضعًا آخر.
    }
edits-of-places-wait = { $edits ->
        [one] تعديل واحد لمواضع الصورة المصححة ينتظر حتى تقع الكتلة عليها من جديد.
        [two] تعديلان لمواضع الصورة المصححة ينتظران حتى تقع الكتلة عليها من جديد.
        [few] { $edits } تعديلات لمواضع الصورة المصححة تنتظر حتى تقع الكتلة عليها من جديد.
       *[other] { $edits } تعديلًا لمواضع الصورة المصححة تنتظر حتى تقع الكتلة عليها من جديد.
    }
of-points-of-the-former = { $lost ->
        [one] تعديل واحد لنقاط الكتلة السابقة لا ينطبق على الجديدة.
        [two] تعديلان لنقاط الكتلة السابقة لا ينطبقان على الجديدة.
        [few] { $lost } تعديلات لنقاط الكتلة السابقة لا تنطبق على الجديدة.
       *[other] { $lost } تعديلًا لنقاط الكتلة السابقة لا تنطبق على الجديدة.
    }
cannot-be-done-again = { $undone ->
        [one] تعديل واحد متراجَع عنه لنقاط الكتلة السابقة لا يُعاد في الجديدة: { $steps }.
        [two] تعديلان متراجَع عنهما لنقاط الكتلة السابقة لا يُعادان في الجديدة: { $steps }.
        [few] { $undone } تعديلات متراجَع عنها لنقاط الكتلة السابقة لا تُعاد في الجديدة: { $steps }.
       *[other] { $undone } تعديلًا متراجَعًا عنها لنقاط الكتلة السابقة لا تُعاد في الجديدة: { $steps }.
    }
places-set-aside = { $steps ->
        [one] تُراجع عن خطوة واحدة لمواضع يدوية لأنها تعيد الكتلة إلى الصورة المصححة:
        [two] تُراجع عن خطوتين لمواضع يدوية لأنهما تعيدان الكتلة إلى الصورة المصححة:
        [few] تُراجع عن { $steps } خطوات لمواضع يدوية لأنها تعيد الكتلة إلى الصورة المصححة:
       *[other] تُراجع عن { $steps } خطوة لمواضع يدوية لأنها تعيد الكتلة إلى الصورة المصححة:
    } الإعادة تجريها من جديد.
nothing = لا شيء
step-join = دمج { $points ->
        [one] نقطة واحدة
        [two] نقطتين
        [few] { $points } نقاط
       *[other] { $points } نقطة
    }
step-split = فصل نقطة إلى { $added }
step-edits =
    { $edits ->
        [one] تعديل واحد
        [two] تعديلان
        [few] { $edits } تعديلات
       *[other] { $edits } تعديلًا
    }
step-measure-in = { $verb ->
        [match] مطابقة
       *[measure] قياس
    } { $what } في { $images }
step-measure = { $verb ->
        [match] مطابقة
       *[measure] قياس
    } { $observations ->
        [one] رصدة واحدة
        [two] رصدتين
        [few] { $observations } أرصاد
       *[other] { $observations } رصدة
    }{ $place }
step-observations = { $verb ->
        [reject] رفض
       *[restore] استعادة
    } { $observations ->
        [one] رصدة واحدة
        [two] رصدتين
        [few] { $observations } أرصاد
       *[other] { $observations } رصدة
    }{ $place }
step-points = { $verb ->
        [reject] رفض
       *[restore] استعادة
    } { $points ->
        [one] نقطة واحدة
        [two] نقطتين
        [few] { $points } نقاط
       *[other] { $points } نقطة
    }
step-named = { $verb ->
        [reject] رفض
       *[restore] استعادة
    } { $name }
step-add-point = إضافة نقطة في { $images ->
        [one] صورة واحدة
        [two] صورتين
        [few] { $images } صور
       *[other] { $images } صورة
    }
step-add-place = إضافة الموضع { $name }
step-use = { $use ->
        [none] استبعاد { $name }
        [control] استعمال { $name } نقطة ضبط
       *[check] استعمال { $name } نقطة تحقق
    }
so-many-pairs = { $pairs ->
        [zero] لا أزواج
        [one] زوج واحد
        [two] زوجان
        [few] { COUNT($pairs) } أزواج
       *[other] { COUNT($pairs) } زوجًا
    }
one-surveyed-point = نقطة ضبط أرضي أو تحقق واحدة
in-image = {" "}في { $name }
rejected-as-a-gross-error = مرفوض خطأً جسيمًا
link-measured-by-hand = مقيس يدويًا، { $use ->
        [used] مستعمل
        [check] تحقق
        [by_hand] مرفوض يدويًا
       *[gross_error] مرفوض خطأً جسيمًا
    }
add-a-link = إضافة رابط
link-2 = { $kind ->
        [reject] رفض
       *[restore] استعادة
    } الرابط { $link }
features-2 = السمات: { COUNT($features) }،{" "}
in-of-9-von-gruber = {" "}في { $places } من 9 مواضع فون غروبر
observations-4 = { $name }: { $what }الأرصاد: { COUNT($rays) }{ $what_2 }
connected-with-of-images = متصلة بـ{ COUNT($partners) } من { COUNT($images) } من الصور
used-as-stored-exif-orientation = مستعملة كما خُزّنت، اتجاه EXIF { $exif_orientation }
pair-rejected-by-hand = مرفوض يدويًا؛ { $reason }
this-pair-was-not-tried = { $names }: لم يُجرَّب هذا الزوج (يتخطاه اختيار الأزواج).
common-points-selected = النقاط المشتركة: { COUNT($shared) }، المختارة: { COUNT($chosen) }
rays-3 = { $name }: الأشعة { COUNT($rays) }
to = { COUNT($least) } إلى { COUNT($most) }
rmse-px-5 = ؛ RMSE { FIXED($squares, digits: 2) } بكسل
rejected-by-hand-3 = ؛ { COUNT($gone) } مرفوضة يدويًا
tie-points-of-rays = { $surveyed ->
        [0] نقاط الربط: { COUNT($chosen) }
       *[other] النقاط: { COUNT($chosen) }، منها نقاط ضبط أرضي أو تحقق: { COUNT($surveyed) }
    }، أشعتها { $rays }{ $what }{ $what_2 }.

## view

opens-the-chosen-pair = يفتح الزوج المختار
chooses-nothing = لا يختار شيئًا
images-of-a-block-measuring = صور الكتلة، أثناء القياس
images-of-a-block = صور الكتلة
measures-the-chosen-point = يقيس النقطة المختارة
measures-a-new-tie-point = يقيس نقطة ربط جديدة
matches-the-point-in-the = يطابق النقطة في الصور الأخرى بالمربعات الصغرى؛ ومع Shift في الصورة النشطة وحدها انطلاقًا من صورة أخرى
gives-up-measuring = يترك القياس
takes-the-middle-of-the = يأخذ وسط اللوح، ثم الموضع المتوقع، ثم يقبل النقطة
chooses-the-next-tie-point = يختار نقطة الربط التالية في الصورة النشطة
chooses-the-previous-tie-point = يختار نقطة الربط السابقة في الصورة النشطة
shows-the-next-images = يعرض الصور التالية
shows-the-previous-images = يعرض الصور السابقة
goes-to-the-next-pane = ينتقل إلى اللوح التالي
links-all-panes-or-no = يربط الألواح كلها أو يفكها
shows-the-loupe-or-no = يُظهر العدسة أو يخفيها
shows-images-in-which-the = يعرض الصور التي لم تُقس فيها النقطة
matching-in-the-other-images = مطابقة في الصور الأخرى انطلاقًا من { $image } …
matching-in-one-image = مطابقة في { $image } …
matched-in-one-image = طوبقت في { $image } انطلاقًا من { $by }. { $what }
no-other-has-the-point = لم تُطابَق: لا صورة أخرى معروضة فيها النقطة.
cancelled-nothing-was-matched = أُلغي. لم يُطابَق شيء.
not-matched = لم يُطابَق: { $error }.
enter-accepts = Enter يقبل.
matched-in-of-images = طوبقت في { $count } من { $found } من الصور. { $what }
images-4 = { $lost } من الصور
no-match-is-confirmed-in = { $done } لم تتأكد مطابقة في { $where }: النسيج قليل، أو المظهر مختلف كثيرًا.
px-4 = { $px } بكسل × { $factor }
drawn-longer = مرسومة × { $factor }
between-clauses = ؛{" "}
chooses-the-next-image = يختار الصورة التالية
chooses-the-previous-image = يختار الصورة السابقة
chooses-the-next-pair-of = يختار الزوج التالي للصورة
gnss-minus-adjusted-up-to = ‏GNSS ناقص المضبوط: حتى { $gnss }
adjusted-minus-surveyed-up-to = المضبوط ناقص الممسوح: حتى { $surveyed }
sought-from-here = يُبحث من هنا

## The answer

block-images = الصور: { COUNT($images) }.
block-done =
    { $verdict } { $images ->
        [zero] لا صور
        [one] صورة واحدة
        [two] صورتان
        [few] { COUNT($images) } صور
       *[other] { COUNT($images) } صورة
    }{ $skipped ->
        [0] {""}
        [1] ، تُخطّي { $name } ({ $reason })
       *[other] ، المتخطى { COUNT($skipped) }، أولها { $name } ({ $reason })
    }، { $pairs ->
        [zero] لا أزواج متصلة
        [one] زوج متصل واحد
        [two] زوجان متصلان
        [few] { COUNT($pairs) } أزواج متصلة
       *[other] { COUNT($pairs) } زوجًا متصلًا
    }، { $found ->
        [none] { $points ->
            [one] نقطة ربط واحدة
            [two] نقطتا ربط
            [few] { COUNT($points) } نقاط ربط
           *[other] { COUNT($points) } نقطة ربط
        }
       *[other] اختيرت { COUNT($points) } من { $found ->
            [one] نقطة ربط واحدة
            [two] نقطتي ربط
            [few] { COUNT($found) } نقاط ربط
           *[other] { COUNT($found) } نقطة ربط
        }
    }{ $surveyed ->
        [0] {""}
        [one] ، ونقطة ضبط أو تحقق واحدة
        [two] ، ونقطتا ضبط أو تحقق
        [few] ، و{ COUNT($surveyed) } نقاط ضبط وتحقق
       *[other] ، و{ COUNT($surveyed) } نقطة ضبط وتحقق
    }.{ $time ->
        [none] {""}
       *[other] {" "}{ $time }.
    }{ $warnings ->
        [0] {""}
        [one] {" "}تحذير واحد، انظر «التفاصيل».
        [two] {" "}تحذيران، انظر «التفاصيل».
        [few] {" "}{ COUNT($warnings) } تحذيرات، انظر «التفاصيل».
       *[other] {" "}{ COUNT($warnings) } تحذيرًا، انظر «التفاصيل».
    }
block-not-oriented =
    { $why }{ $group ->
        [none] {""}
       *[other] {" "}في كبرى مجموعات الصور المتصلة { COUNT($group) } من { COUNT($images) }: هل تتداخل؟
    } المحفوظ: { COUNT($images) } من الصور مع سماتها، { $pairs ->
        [zero] لا أزواج متصلة
        [one] زوج متصل واحد
        [two] زوجان متصلان
        [few] { COUNT($pairs) } أزواج متصلة
       *[other] { COUNT($pairs) } زوجًا متصلًا
    }، { $points ->
        [zero] لا نقاط ربط
        [one] نقطة ربط واحدة
        [two] نقطتا ربط
        [few] { COUNT($points) } نقاط ربط
       *[other] { COUNT($points) } نقطة ربط
    }.
geometry =
    { $model }{ $weak ->
        [none] {""}
       *[other] ، { $weak }
    }، ± { FIXED($sigma_px, digits: 2) } بكسل
gives-up-or-chooses-nothing = يترك، أو لا يختار شيئًا
accepts-the-link-that-is = يقبل الرابط المقيس
adds-a-place-or = يقيس موضعًا من الصورة المصححة للكتلة أو يتركه
takes-the-place-under-the-cross = يأخذ الموضع الذي تحت علامة التقاطع
adds-no-place = يترك الموضع
measures-a-new-link-or = يقيس رابطًا جديدًا أو يتركه
uses-the-chosen-link-again = يستعمل الرابط المختار من جديد
rejects-the-chosen-link = يرفض الرابط المختار
chooses-the-previous-image-that = يختار الصورة الموضوعة السابقة
chooses-the-next-image-that = يختار الصورة الموضوعة التالية
chooses-the-previous-link-of = يختار رابط الصورة السابق
chooses-the-next-link-of = يختار رابط الصورة التالي
point-of-number = النقطة { COUNT($number) }
within = ± { $length }
projection-centres-95 = مراكز الإسقاط (95 %)

use-by-hand = { $use }، يدويًا
given-use = { $role ->
    [control] ضبط
    [check] تحقق
   *[none] غير مستعملة
  } · { $images ->
    [zero] لم تُقَس
    [one] مقيسة في صورة واحدة
    [two] مقيسة في صورتين
    [few] مقيسة في { $images } صور
   *[other] مقيسة في { $images } صورة
  }
given-point = { $name }: X Y Z { $place }؛ { $use }.
given-point-of-file = { $name }: X Y Z كما أُعطيت { $place }؛ { $use }.
measured = مقيسة
marks-by-hand = القياسات الصورية اليدوية
mark-of = { $point } في { $image }
several-pairs =
    { $pairs ->
        [two] زوجان
        [few] { COUNT($pairs) } أزواج
       *[other] { COUNT($pairs) } زوجًا
    }: { $names }.
several-images =
    { $images ->
        [two] صورتان
        [few] { COUNT($images) } صور
       *[other] { COUNT($images) } صورة
    }: { $names }.
step-remove-images = إزالة { $images ->
        [one] صورة واحدة
        [two] صورتين
        [few] { $images } صور
       *[other] { COUNT($images) } صورة
    }
step-make-frames = تحويل { $scans ->
        [one] مسح واحد
        [two] مسحين
        [few] { $scans } مسوح
       *[other] { COUNT($scans) } مسحًا
    } إلى صور كاميرا واحدة
step-beside-images = قياس خارج صور المسوح
step-place-in = وضع النقطة في { $image }
several-observations = { $observations ->
        [one] رصدة واحدة
        [two] رصدتان
        [few] { $observations } رصدات
       *[other] { COUNT($observations) } رصدة
    } من { $points ->
        [one] نقطة واحدة
        [two] نقطتين
        [few] { $points } نقاط
       *[other] { COUNT($points) } نقطة
    }.
step-unmark = إزالة قياس { $what } في { $images }
control-waits = لا تشارك نقاط الضبط بعد: { $twice ->
    [zero] لم تُقَس أي منها
    [one] قيست نقطة واحدة
    [two] قيست نقطتان
    [few] قيست { $twice } نقاط
   *[other] قيست { $twice } نقطة
  } في صورتين أو أكثر، والمطلوب { $needed ->
    [one] واحدة
   *[other] { $needed }
  }. اخترها في جدول نقاط الضبط والتحقق واضغط «قياس».
control-can-be-taken = { $twice ->
    [one] نقطة واحدة مقيسة
    [two] نقطتان مقيستان
    [few] { $twice } نقاط مقيسة
   *[other] { $twice } نقطة مقيسة
  } في صورتين أو أكثر.
taking-the-control = تُضبط الكتلة معها من جديد مما تمت مطابقته، ويستغرق ذلك ثواني.{ $kept ->
    [edits] { " " }تبقى التعديلات اليدوية، ما عدا تعديلات نقاط ربطها.
   *[none] { "" }
  }
take-the-control = إدخالها في الكتلة
