# Texts of the page of a pair, in Arabic; names, figures and order are those of the English texts, the terms those of docs/terms.md.

## engine

left-image = الصورة اليسرى
right-image = الصورة اليمنى
the-project-does-not-hold = لا يحوي المشروع صوره؛ افتح { $name } أيضًا
images-settings-and-earlier-results = الصور والإعدادات والنتائج السابقة محفوظة.
try-a-smaller-image-or = جرّب صورة أصغر، أو أغلق ألسنة تبويب أخرى.
try-a-higher-threshold-or = جرّب عتبة أعلى أو صورة أصغر، ثم أعد التشغيل.
try-fewer-points-a-higher = جرّب نقاطًا أقل (عتبة أعلى أو نافذة كبت أكبر) أو نافذة بحث أصغر، ثم أعد التشغيل.
change-a-setting-or-run = غيّر إعدادًا أو أعد التشغيل.
failed = أخفقت المرحلة «{ $label }»: { $text }. { $kept }
memory-ran-out-while = نفدت الذاكرة أثناء { $label } ({ $text }). { $kept } { $stage }
the-program-broke-off-while = انقطع البرنامج أثناء { $label } ({ $text }): عطل فيه نرجو الإبلاغ عنه. { $kept } { $stage }
failed-2 = أخفقت المرحلة «{ $label }»: { $text }. { $kept } { $stage }

## files

the-edits-of-other-pairs = تعديلات الأزواج الأخرى تالفة
restored-from-this-browser-2 = استُرجع من هذا المتصفح: { $title_of }.
an-image-is-damaged = إحدى الصور تالفة
the-truth-of-the-simulated = حقيقة الزوج المحاكى تالفة
the-picture-is-too-large = الصورة أكبر من أن يرمّزها هذا المتصفح؛ صغّر النافذة
it-holds-the-history-of = يحوي { $join }؛ سجل هذه التعديلات ليس في الملف، فلا يمكن التراجع عنها.
was-opened-the-file-does-not = فُتح { $name }. لا يحوي الملف صوره: افتحها أيضًا لتراها.
is-a-mask-of-the = ‏{ $name } قناع الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    }، وهي غير مفتوحة. افتحها أولًا.
has-px-the-image-px = أبعاد { $name } هي { $width } × { $height } بكسل، وأبعاد الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    } { $width_2 } × { $height_2 } بكسل: القناع بحجم صورته. لم يتغير شيء.
masks-of-the-image = يحجب { $name } ما نسبته { FIXED($left_out, digits: 1) } % من الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    }.
cannot-be-used-as-a = لا يمكن استعمال { $name } قناعًا
cancelled-before-they-were-read = { $files ->
        [one] لم يُقرأ { $names }: أعطه من جديد.
        [two] لم يُقرأ الملفان { $names }: أعطهما من جديد.
       *[other] لم تُقرأ الملفات { $names }: أعطها من جديد.
    }
rendering-the-pair-a-simulated = يُولَّد الزوج: طيران محاكى فوق مشهد اصطناعي …
the-pair-could-not-be = تعذر توليد الزوج
the-open-images-are-kept = {" "}الصور المفتوحة باقية.
fiducial-of-the-image-from = { $fiducials ->
        [one] علامة إطارية واحدة
        [two] علامتان إطاريتان
        [few] { $fiducials } علامات إطارية
       *[other] { $fiducials } علامة إطارية
    } للصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    } من { $name }.
is-no-photograph-and-no-table = ليس { $name } صورة ولا جدولًا معروفًا هنا
is-a-table-of-a-block = لا يحوي { $name } علامات إطارية: يُقرأ نقاطَ ضبط أو قياسات صورية أو مواضع GNSS، وهي للكتلة. أعطه مع الصور تحت «الكتلة».
camera-data-from = بيانات الكاميرا من { $name }.
holds-no-camera-data = لا يحوي { $name } بيانات كاميرا
has-mb-up-to-1 = حجم { $name } هو { $size } ميغابايت؛ يُقرأ حتى 1024 ميغابايت.
reading-2 = تجري قراءة { $join } …
the-file = الملف
marks-went-with-the-image = ذهب مع الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    } السابقة ما قيس فيها: { $marks ->
        [0] موضعها في المسح
        [one] علامة إطارية واحدة
        [two] علامتان إطاريتان
        [few] { $marks } علامات إطارية
       *[other] { $marks } علامة إطارية
    }.
stay-under-projects = يبقى { $title_of } في المشاريع.
open-the-other-pair = افتح الزوج الآخر
could-not-be-opened-try = تعذر فتح { $name }: { $breakdown }. جرّب صورة أصغر، أو أغلق ألسنة تبويب أخرى.
the-pair-is-not-matched = لم يُطابَق الزوج بالإعدادات الحالية بعد
report-reading-the-images = التقرير: تجري قراءة الصور …
report-step-of-matching = التقرير، الخطوة { $i } من { $steps }: المطابقة، { $step } …
report-step-of-writing = التقرير، الخطوة { $steps } من { $steps }: الكتابة …
its-run-has-the-edits = في تشغيله التعديلات اليدوية، أما الاستراتيجيات الأخرى فتطابق من جديد دونها.
the-report-was-cancelled = أُلغي التقرير.
epipolar-images-are-made = الصورتان القطبيتان: جارٍ إعادة التشكيل…
epipolar-images-were-saved = حُفظت الصورتان القطبيتان: اليسرى واليمنى وصورة مجسَّمة (أناغليف). بقي من اختلاف المنظر الصادي لـ { COUNT($points) } من النقاط { FIXED($left_over, digits: 2) } بكسل (الجذر التربيعي لمتوسط المربعات).
cancelled-nothing-was-saved-the-epipolar = أُلغي: لم تُصنع الصورتان القطبيتان.

## mount and answer

settings-of-the-pair = إعدادات الزوج
details-of-the-point = التفاصيل: النقطة المحددة
n--4 = { $label }.
point-at =
    النقطة { $side ->
        [left] اليسرى
       *[right] اليمنى
    } { COUNT($index) } عند { FIXED($x, digits: 1) }، { FIXED($y, digits: 1) } بكسل. { $what }
loading-the-program = يُحمَّل البرنامج …
loading-the-program-files = يُحمَّل البرنامج … ملفات تنتظر أن تُفتح: { COUNT($files) }.
ready-open-two-overlapping-images = جاهز. افتح صورتين متداخلتين، أو استعمل الزوج النموذجي.
one-image-is-open-open = صورة واحدة مفتوحة. افتح الصورة { $missing ->
        [left] اليسرى
       *[right] اليمنى
    }.
open-the-image = افتح الصورة { $missing ->
        [left] اليسرى
       *[right] اليمنى
    } …
waiting = انتظار …
use-auto = استعمل «auto»
give-the-camera = أعط الكاميرا
open-other-photos = افتح صورًا أخرى …
is-a-third-image = { $name } صورة ثالثة: أتُفتح الثلاث كتلةً، أم تحل محل الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    }؟
is-the-other-image-already = { $name } هي الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    } من قبل. لم يتغير شيء.
open-three-as-a-block = افتح الثلاث كتلةً
keep-the-pair = أبقِ الزوج
replace-the-right-image = استبدل الصورة اليمنى …
use-the-calibrated-camera = استعمل الكاميرا المعايرة
points-on-both-photos = نقاط في الصورتين
right-photo-turned = دوران الصورة اليمنى (κ)
points-tried = نقاط جُرّبت

## camera

principal-pt-x = النقطة الأساسية x
principal-pt-y = النقطة الأساسية y
forget-this-calibration = انس هذه المعايرة
the-calibration-is-forgotten = نُسيت المعايرة.
the-camera-that-was-given-stays = تبقى الكاميرا المعطاة مستعملة.
the-calibrated-camera-is-not = الكاميرا المعايرة ليست كاميرا هاتين الصورتين: تُستعمل كاميرتهما.
a-block-calibrated-such-a-camera = عايرتها في { $day } كتلةٌ صورها { COUNT($images) } بكاميرا من هذا الصانع والطراز: البعد البؤري { FIXED($focal, digits: 1) } ± { FIXED($error, digits: 1) } بكسل.
load-camera-json = تحميل camera.json …
the-image-is = الصورة { $name ->
        [left] اليسرى
       *[right] اليمنى
    }: { $message }.
no-pixel-size = بلا حجم بكسل
pixel-mm = البكسل { $pixel_mm } مم
caution = {" "}تنبيه: { $message }.
camera-not-named = الكاميرا غير مسماة
f-mm = { $message }، { $name ->
        [left] اليسرى
       *[right] اليمنى
    }: { $what }، البعد البؤري { $focal_mm } مم، { $pixel }.{ $cautions }
they-came-with-the-sample = {" "}(جاءت مع النموذج)
in-use-the-values-below = المستعمل: القيم أدناه{ $what }{ $told }. { $exif }
the-focal-length-is-not-used-yet = البعد البؤري غير مستعمل بعد: أعطِ حجم البكسل، أو البعد البؤري بالبكسل، أو الالعلامات الإطاريةية للصورتين. { $exif }
focal-length-in-px-sets = { $what ->
        [scans] مع الالعلامات الإطاريةية يكون البعد البؤري بالمليمتر.
        [pixel] يحدد البعد البؤري بالبكسل حجمَ البكسل، بحسب البعد البؤري بالمليمتر.
       *[focal] يحدد البعد البؤري بالبكسل البعدَ البؤري بالمليمتر، بحسب حجم البكسل؛ فإن لم يُعطَ فلبكسلات قدرها 0.001 مم. ويحل محله البعد البؤري وحجم البكسل بالمليمتر.
    }
use-the-camera-for-both = استعمال كاميرا الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    } للصورتين
in-use-the-photos-own = المستعمل: كاميرا الصور نفسها{ $told }. تحل القيم أدناه محلها. { $exif }
no-camera-is-known = لا كاميرا معروفة: { $source ->
        [estimated] تُقدَّر من المطابقات
       *[assumed] تُفترض كاميرا معظم الصور
    }{ $told }. تحل القيم أدناه محلها. { $exif }
orientation-needs-a-focal-length = يحتاج التوجيه إلى بعد بؤري بالبكسل، أو بالمليمتر مع حجم بكسل أو علامات إطارية. ومع مطابقات التدرجات يستغني عنها. { $exif }
focal-length-px = ، البعد البؤري { FIXED($focal, digits: 0) } ± { FIXED($error, digits: 0) } بكسل
offset-dx = الإزاحة dx
offset-dy = الإزاحة dy
matching-by-gradients-searches-the = تبحث المطابقة بالتدرجات في الصورة اليمنى كلها: لا تحتاج إلى إزاحة.
given-clear-both-fields-to = معطاة. أفرغ الحقلين لتقديرها.
right-minus-left-position-empty = الموضع الأيمن ناقص الأيسر. فارغة: تُقدَّر بالارتباط من الخشن إلى الدقيق.
correlation-2 = ، الارتباط { FIXED($correlation, digits: 2) }
low-do-the-images-overlap = : ضعيف. هل تتداخل الصورتان؟ قد تفيد إزاحة معطاة
estimated-median-px = مقدَّرة: الوسيط { $mx }، { $my } بكسل{ $what }{ $what_2 }.
offset-of-the-right-image = إزاحة الصورة اليمنى

## counts

operator = المؤثر
roundness = الاستدارة
suppression = الكبت
points-after-each-phase = النقاط بعد كل مرحلة
phase = المرحلة
left = اليسرى
right = اليمنى
the-papers-table-1-for = الجدول 1 في البحث، لزوجه
paper-l-r = البحث، يسار / يمين
matching = المطابقة
threshold = العتبة
what-became-of-the-left = مصير النقاط اليسرى
left-points = النقاط اليسرى
number = العدد
share = النسبة
of-these-gross-errors = منها أخطاء جسيمة
rejected-by = الرافض
of-these-measured-by-hand = منها مقيسة يدويًا
show-2 = إظهار: { $own }
matches-against-the-truth = المطابقات مقارنة بالحقيقة
right-matches = صحيحة
within-1-5-px-of = ضمن 1.5 بكسل من الموضع الذي يُرى فيه السطح عند البكسل الأيسر أو عند أحد جيرانه الثمانية: تقع النقاط على الحواف حيث قد يقفز السطح بين بكسلين.
strictly-right = صحيحة تمامًا
within-1-5-px-of-where = ضمن 1.5 بكسل من الموضع الذي يُرى فيه السطح عند البكسل الأيسر نفسه.
missed = فائتة
left-points-that-are-visible = نقاط يسرى تُرى في الصورة اليمنى وليس لها مطابقة صحيحة.

## edits

add-match = إضافة مطابقة
measure-a-match-by-hand = قياس مطابقة يدويًا (A)
the-match-is-measured-enter = تم قياس المطابقة (Enter)
move-the-right-point-to = ينقل النقطة اليمنى إلى حيث تجدها المطابقة بالمربعات الصغرى (F)
other-image = الصورة الأخرى
go-on-with-the-point = المتابعة بالنقطة في الصورة الأخرى (O)
give-this-match-up-escape = ترك هذه المطابقة (Escape)
match-measured-by-hand = مطابقة مقيسة يدويًا
new-match-press-a-point = مطابقة جديدة: اضغط نقطة في إحدى الصورتين، أو Enter لوسط الصورة النشطة.
new-match = مطابقة جديدة
moved-match = مطابقة منقولة
px-predicted = مطابقة جديدة: { $place } · { $place_2 } بكسل. النقطة { $side ->
        [left] اليسرى
       *[right] اليمنى
    } متوقعة: اضغطها، أو انقلها بالأسهم، أو دع المربعات الصغرى تجدها (F).
px-place-the-point-press = { $what }: { $place } · { $place_2 } بكسل. ضع النقطة { $side ->
        [left] اليسرى
       *[right] اليمنى
    }: بالضغط، أو بالأسهم 0.1 بكسل، ومع Shift بكسلًا واحدًا.
take-the-chosen-matches-out = يخرج المطابقات المختارة من التوجيه (Delete)
use-the-chosen-matches-again = يستعمل المطابقات المختارة من جديد (R)
move = نقل
measure-the-selected-match-anew = قياس المطابقة المحددة من جديد في أي من الصورتين (E)
take-back-the-last-edit = التراجع عن آخر تعديل (Ctrl+Z)
make-the-edit-again-that = إعادة التعديل الذي تُراجع عنه (Ctrl+Shift+Z أو Ctrl+Y)
to-reject-wrong-matches-choose = لرفض المطابقات الخاطئة اخترها: اضغط صفًا أو نقطة، ومع Ctrl أكثر من واحدة، أو ارسم مستطيلًا في صورة مع Shift. ثم اضغط Delete.
history-2 = السجل: { $edits ->
        [zero] لا تعديلات
        [one] تعديل واحد
        [two] تعديلان
        [few] { COUNT($edits) } تعديلات
        [many] { COUNT($edits) } تعديلًا
       *[other] { COUNT($edits) } تعديل
    }
history-of-masks = الأقنعة
history-of-marks = العلامات الإطارية
masks-as-given = الأقنعة كما أُعطيت
marks-as-given = العلامات كما أُعطيت
as-matched = كما طوبق
now-2 = الآن
standard-error-of-4 = الخطأ المعياري لـ{ $symbol }، °
points-used = النقاط المستعملة
orientation-before-and-after-the = التوجيه قبل التعديل وبعده
choose = اختيار
choose-matches-by-a-rectangle = اختيار المطابقات بمستطيل لرفضها أو استعادتها (S؛ أو Shift مع السحب)
rejects-the-chosen-matches = يرفض المطابقات المختارة
needs-two-photos = يلزم صورتان
needs-a-photo = تلزم صورة
no-camera-is-given = لم تُعطَ كاميرا
nothing-is-outlined = لم تُحدَّد منطقة
needs-matches = يلزم صور مطابقة
no-such-match-is-chosen = لم تُختر مطابقة كهذه
no-point-is-selected = لم تُحدد نقطة
restores-the-chosen-matches = يستعيد المطابقات المختارة
chooses-the-selected-match-beside = يختار المطابقة المحددة مع غيرها، أو يلغي اختيارها
measures-the-selected-match-anew = يقيس المطابقة المحددة من جديد
gives-up = يترك
list-of-matches = قائمة المطابقات

## feature and fiducials

no-point = لا نقطة.
no-interest-point-here = { $by ->
        [hand] وُضعت يدويًا: لا نقطة مميزة هنا.
       *[least_squares] وُضعت بالمربعات الصغرى: لا نقطة مميزة هنا.
    }
point-2 = النقطة { $label }، { $name }
turned-and-scaled-to-the = مدارة ومقيسة على النقطة، مع مدّ التباين
descriptor-as-it-lies-in = الواصف كما يقع في الصورة
scale-px-direction-px-wide = {" "}· المقياس { FIXED($scale, digits: 1) } بكسل، الاتجاه { FIXED($direction, digits: 0) }°، العرض { FIXED($reach, digits: 0) } بكسل
col-px = العمود بكسل
row-px = الصف بكسل
affine-6-parameters = أفيني، 6 معاملات
similarity-4-parameters = تشابه، 4 معاملات
interior-orientation = التوجيه الداخلي
transformation = التحويل
add-mark = إضافة علامة
load-csv = تحميل CSV …
image-4 = الصورة { $name }
no-fiducial-marks-and-no-pixel = لا علامات إطارية، وحجم البكسل غير معروف.
no-fiducial-marks-the-pixel = لا علامات إطارية. يُستعمل حجم البكسل.
measure-in-the-image = قياس في الصورة
press-each-mark-in-the-image = اضغط كل علامة في الصورة؛ وحين تُعرف علامتان أو أكثر تُتوقَّع التالية عند حلقة متقطعة
incomplete-marks = العلامات غير المكتملة: { $incomplete }، ولا تشارك.
marks = العلامات: { $marks }.
not-determined = غير محددة
um-1 = { FIXED($value, digits: 1) } ميكرومتر
marks-degrees-of-freedom = العلامات: { $marks }، σ₀ { $what }، درجات الحرية: { $freedom }.
fiducial-marks = الالعلامات الإطاريةية، { $side ->
        [left] اليسرى
       *[right] اليمنى
    }
residuals-vx-vy = المتبقيات vx، vy
mark = العلامة { $index }، { $heads }
remove-mark = إزالة العلامة { $index }
origin-of-the-image-in = مبدأ الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    } في المسح الضوئي
image-in-the-scan-px =
    الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    } في المسح الضوئي، { $name }، بكسل
column-and-row-of-this = عمود وصف الركن الأيسر العلوي لهذه الصورة في المسح الضوئي الذي قيست فيه العلامات. فارغ: الصورة هي المسح كله.
origin-in-the-scan = المبدأ في المسح الضوئي{" "}
col-row-px = العمود، الصف بكسل

## geometry

geometry-of-the-two-views = هندسة المشهدين
not-computed-yet = لم تُحسب بعد.
none = لا شيء: { $message }.
model = النموذج
matches-that-agree = المطابقات المتفقة
all-others-are-rejected-matches = كل ما سواها مرفوض. ومنها مطابقات لم يزل التباسها إلا بالهندسة.
standard-error-of-a-coordinate = الخطأ المعياري للإحداثي
from-the-distances-of-these = من أبعاد هذه المطابقات عن خطوطها القطبية، أو عن مواضعها المتوقعة.
largest-distance-of-a-match = أكبر بعد لمطابقة متفقة. يُستنتج من تشتت المطابقات حيث لم يُعط.
focal-length-estimated = البعد البؤري المقدَّر
px-5 = { FIXED($focal_px, digits: 0) } ± { FIXED($standard_error_px, digits: 0) } بكسل
of-both-cameras-from-the = للكاميرتين، من المطابقات وحدها، مع خطئه المعياري. تُفترض النقطة الأساسية في مركز الصورة. خطأ نسبي قدره العُشر صغير بما يكفي للتوجيه النسبي.
the-truth-of-the-simulated-pair = حقيقة الزوج المحاكى تصح بترتيبه فقط: بدّل مرة أخرى للمقارنة.

## histograms and matrix

histograms = المدرجات التكرارية
no-points-yet = لا نقاط بعد.
measure-of-the-matches = مقياس المطابقات
y-parallax-residuals-of-the = متبقيات اختلاف المنظر الصادي للمطابقات المستعملة
interest-value-left = قيمة التمييز، اليسرى
interest-value-right = قيمة التمييز، اليمنى
values-median-shown-from-to = { $title }: عدد القيم { COUNT($total) }، الوسيط { $median }{ $suffix }، المعروض من { $low } إلى { $high }{ $suffix }، وأكثر ما في عمود { COUNT($most) }
median = الوسيط { $median }
and = { $symbol } و{ $symbol_2 } { FIXED($correlations, digits: 2) }
from-the-inverse-of-the = من معكوس المعادلات الناظمة: قرب ±1 لا يكاد مجهولان ينفصلان، وينتقل خطأ أحدهما إلى الآخر.
correlations-of-the-unknowns = ارتباطات المجاهيل
correlations = الارتباطات: { $join }
standard-error-ellipse-of-by = قطع الخطأ المعياري للمركبتين by وbz: نصفا محوريه { $major } و{ $minor } مم، ومحوره الأطول على { FIXED($angle, digits: 0) } درجة من by
cross-truth = ؛ العلامة المتصالبة: الحقيقة
by-bz-ellipse-m = ‏by، bz: قطع الخطأ المعياري، نصفا محوريه { $major } × { $minor } ميكرومتر{ $what }
dashed-95 = ؛ المتقطع: 95 %

## orientation

mark-before = السابقة
the-mark-before-p = العلامة السابقة (P)
next-mark = التالية
the-next-mark-enter = العلامة التالية (Enter)
clear-mark = محو
the-mark-is-not-measured = تُعد العلامة غير مقيسة
end-marking = إغلاق
step-of-mark = { $deed ->
        [measured] قياس العلامة الإطارية { $number } في { $image }
        [moved] نقل العلامة الإطارية { $number } في { $image }
        [nudged] نقل العلامة الإطارية { $number } في { $image }
        [cleared] محو قياس العلامة الإطارية { $number } في { $image }
        [typed] تغيير العلامة الإطارية { $number } في { $image }
        [coordinates] أخذ الإحداثيات الصورية للصورة { $image }
        [added] إضافة العلامة الإطارية { $number } إلى { $image }
        [removed] إزالة العلامة الإطارية { $number } من { $image }
        [given] أخذ جدول العلامات الإطارية للصورة { $image }
       *[all_removed] إزالة كل العلامات الإطارية من { $image }
    }
step-of-mask = { $deed ->
        [masked] تقنيع مساحة في { $image }
        [unmasked] رفع القناع عن مساحة في { $image }
        [given] استعمال { $mask } قناعًا للصورة { $image }
       *[removed] إزالة قناع { $image }
    }
as-in-the-other-image = x وy كما في الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    }
takes-the-photo-coordinates = يأخذ الإحداثيات الصورية x وy الناقصة هنا من علامات الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    } بترتيبها: فهي واحدة للكاميرا الواحدة
fiducial-marks-measured = علامات إطارية تقاس في الصورة
mark-at-mm = { " " }({ $x }، { $y } مم)
mark-is-at = العلامة { $number }{ $photo } عند { $column }، { $row } بكسل من الصورة. الأسهم تحركها؛ وEnter يتابع.
mark-beside-the-picture = لم توضع العلامة: ذلك الموضع خارج الصورة.
new-mark-press-it = علامة جديدة { $number }: اضغطها في الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    }؛ واكتب إحداثيي صورتها تحت «الكاميرا».
mark-press-it = العلامة { $number }{ $photo }: اضغطها في الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    }.
mark-is-expected = العلامة { $number }{ $photo }: اضغطها في الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    }، قرب الحلقة المتقطعة.

mask-areas = تقنيع مساحات
outline-areas-in-which-no = حدِّد مساحات لا تُراد فيها نقاط: الماء والسيارات وحافة المسح (W)
mask-it = تقنيع
no-points-in-the-outlined = لا نقاط في المساحة المحددة (K)
unmask-it = رفع القناع
points-in-the-outlined-area = النقاط في المساحة المحددة من جديد (U)
save-masks = حفظ القناعين
masks-as-png-files-for = القناعان ملفَّي PNG، لاستعمال لاحق أو للأمر
no-area-was-painted = لم تُرسم مساحة: أُلغي ذلك، أو تغيرت الصورة أو قناعها في الأثناء.
end-masking = إغلاق
masks-of-the-pictures = قناعا الصورتين
the-area-is-outlined = عدد الأركان { $corners }: قنِّع المساحة أو ارفع عنها القناع.
draw-round-an-area-or = { $corners ->
    [0] ارسم حول مساحة، أو اضغط أركانها واحدًا بعد آخر. بالمفاتيح: يضع Enter ركنًا عند العلامة في الوسط.
   *[other] عدد الأركان { $corners }: للمساحة ثلاثة على الأقل.
}
the-mask-is-not-here = ملف { $name } ليس هنا: افتحه من جديد، أو أزل القناع، قبل رسم مساحة.

axes-turned = المحاور مدارة 90°: يتجه x إلى أعلى في الصورة اليسرى.
is-computed-from-y-parallaxes = تُحسب σ₀ من اختلافات المنظر الصادية. لا ترى إلا مركبة الخطأ العمودية على الخط القطبي، ولا تثبت صحة مطابقة: مطابقة خاطئة على امتداد الخط لا تغيّرها.
relative-orientation = التوجيه النسبي
two-images-are-needed = المطلوب صورتان.
not-oriented-2 = لم يُوجَّه: { $message }.
not-oriented-do-both-photos = لم يُوجَّه: { $message }. هل تُظهر الصورتان الأرض نفسها؟
and-the-matches-do-not = ، والمطابقات لا تحدد البعد البؤري
not-oriented-give-the-focal = لم يُوجَّه: { $message }{ $untold }. أعط البعد البؤري بالبكسل، أو بالمليمتر مع حجم البكسل أو الالعلامات الإطاريةية، في «الكاميرا».
not-oriented-3 = لم يُوجَّه. { $message }
value = القيمة
the-right-photo-relative-to = الصورة اليمنى بالنسبة إلى اليسرى، توجيه نسبي تابع.
std-error = الخطأ المعياري
what-the-scatter-of-the = ما يتركه تشتت المطابقات غير مؤكد.
in-total = الإجمالي
standard-error-including-what-does = الخطأ المعياري شاملًا ما لا يتلاشى بالمتوسط: تشترك المطابقات المتجاورة في أخطائها لتداخل نوافذها، وتشترك كلها في أخطاء الكاميرا والالعلامات الإطاريةية المقيسة والجدران والأسقف.
half-width-of-the-interval = نصف عرض المجال الذي يحوي المجهول في 95 من 100 حالة: من الخطأ المعياري الأخير، بتوزيع ستودنت لدرجات الحرية.
paper-2 = البحث
the-papers-table-3-of = الجدول 3 في البحث، لزوجه
its-error = خطؤه
the-papers-table-2 = الجدول 2 في البحث
true-error = الخطأ الحقيقي
value-minus-truth-by-and = القيمة ناقص الحقيقة؛ by وbz بمقياس القاعدة المستعملة.
in-std-errors = بالأخطاء المعيارية
the-true-error-divided-by = الخطأ الحقيقي مقسومًا على الخطأ المعياري، مع خطأ التوجيه الداخلي حيث يُعرف: يتجاوز 3 في 3 من 1000 حالة.
unknown = المجهول
of-a-photo-coordinate = ‏σ₀ لإحداثي الصورة
px-6 = {" "}= { FIXED($sigma, digits: 3) } بكسل
standard-error-of-one-photo = الخطأ المعياري لإحداثي صورة واحد وزنه 1، من المتبقيات. { $sigma_caveat }
of-a-y-parallax-2 = لاختلاف المنظر الصادي (√2 σ₀)
standard-error-of-the-y = الخطأ المعياري لاختلاف المنظر الصادي لمطابقة: المسافة التي يمر بها شعاعاها أحدهما بالآخر.
global-test-2 = الاختبار الكلي
passed = ناجح
failed-3 = مخفق
degrees-of-freedom = درجات الحرية
matches-used-minus-the-five = المطابقات المستعملة ناقص المجاهيل الخمسة.
matches-used = المطابقات المستعملة
of-7 = { COUNT($used) } من { COUNT($residuals_mm) }
data-snooping-rejected-the-others = رفض تقصّي البيانات ما سواها أخطاءً جسيمة، أو تلتقي أشعتها خلف كاميرا.
condition = العدد الشرطي
largest-by-smallest-eigenvalue-of = أكبر قيمة ذاتية على أصغرها لمصفوفة الارتباطات: 1 حيث تستقل المجاهيل، وبضعة آلاف للصور الشاقولية، وأكثر بكثير حيث لا تكاد تنفصل.
misfit-to-a-plane = عدم المواءمة لمستوى
how-far-the-matches-deviate = مقدار حيد المطابقات عن أفضل تحويل لمستوى إلى آخر، بالأخطاء المعيارية: نحو 1 فوق مستوى حيث قد يوافقها توجيه ثان بالجودة نفسها؛ وكبير فوق التضاريس.
parallax-beside-a-rotation = اختلاف المنظر بعد الدوران
mm-2 = { $value } مم
px-7 = { $value } بكسل
median-parallax-that-the-best = وسيط اختلاف المنظر الذي يتركه أفضل دوران للصورة اليمنى: ما لا تفسره من اختلاف الصورتين إلا القاعدة. يكاد ينعدم حيث دارت الكاميرا فقط.
spread = الانتشار
root-mean-square-distance-of-the = الجذر التربيعي لمتوسط مربعات أبعاد النقاط عن وسطها في الصورة اليسرى، بوحدة البعد الأساسي. صغير حيث تغطي القليل من الصورة.
iterations-last-step = التكرارات، الخطوة الأخيرة
of-the-tolerance = { $iterations }؛ { $step } من التفاوت المسموح
the-last-step-relative-to = التفاوت المسموح للخطوة جزء من مليون من الأخطاء المعيارية: يكون الضبط قد تقارب إذا كانت الخطوة الأخيرة أصغر منه.
base-b-principal-distance = القاعدة b، البعد الأساسي
mm-mm = { $base_mm } مم، { $focal_mm } مم
the-base-component-that-was = مركبة القاعدة المثبتة تعطي by وbz مقياسهما.
what-the-paper-printed-for = ما طبعه البحث لزوجه.

## panes

replace = استبدال …
replace-the-image = استبدال الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    }
open-the-image-2 = افتح الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    } …
mask = قناع …
an-image-of-the-same = صورة بالحجم نفسه: لا تُكشف نقاط حيث قيمتها 0 (أسود)
mask-2 = × القناع
remove-the-mask-of-the = إزالة قناع الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    }
remove-3 = إزالة { $name }
px-8 = {" "}· { COUNT($width) } × { COUNT($height) } بكسل

## point

click-a-point-in-an = اضغط نقطة في صورة، أو اضغط N والصورة في البؤرة، لترى ما قورن، ومرشحيها، والقاعدة التي حسمت.
point-3 = النقطة { $what } { COUNT($index) }
x-px-y-px-interest = ‏x { FIXED($at, digits: 1) } بكسل، y { FIXED($at_2, digits: 1) } بكسل، قيمة التمييز { $significant }
not-matched-yet = لم تُطابَق بعد.
loading-the-window-and-the = تُحمَّل النافذة والمرشحون …
the-dashed-line-in-the = الخط المتقطع في الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    } هو الخط القطبي لهذه النقطة: تقع عليه مطابقتها أيًا كان الارتفاع.
the-cross-in-the-image = العلامة المتصالبة في الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    } هي حيث تضع الهندسة هذه النقطة.
by-the-geometry-of-the = بحسب هندسة المشهدين تقع هذه النقطة خارج الصورة { $side ->
        [left] اليسرى
       *[right] اليمنى
    }.
axis = {" "}· المحور { FIXED($axis_angle_deg, digits: 1) }°
left-window = النافذة اليسرى
right-window = النافذة اليمنى
normalised-central-moments = العزوم المركزية المعيّرة
moment = العزم
invariants = اللامتغيرات
invariant = اللامتغير
right-position = الموضع الأيمن
px-9 = { FIXED($right, digits: 2) }، { FIXED($right_2, digits: 2) } بكسل
where-the-match-lies-in = حيث تقع المطابقة في الصورة اليمنى.
match = المطابقة { COUNT($index) }
select-right-point = تحديد النقطة اليمنى { COUNT($index) }
distance-2 = البعد
measure = المقياس
rank = الرتبة
right-point = النقطة اليمنى
the-smallest-measure-divided-by = أصغر مقياس مقسومًا على مقياسه: نسبة الثاني تقرر إن كان الأفضل ملتبسًا.
ratio-2 = النسبة
the-match-is-none-of-these = ليست المطابقة أيًّا من هذه: فهذه تُقارن بواصفاتها، أما المطابقة فوضعتها المطابقة بالمربعات الصغرى من جاراتها.
the-best = ، أفضل { $most_rows }
of-left-point = { $total ->
        [zero] لا مرشحين
        [one] مرشح واحد
        [two] مرشحان
        [few] { COUNT($total) } مرشحين
        [many] { COUNT($total) } مرشحًا
       *[other] { COUNT($total) } مرشح
    } للنقطة اليسرى { COUNT($left_index) }{ $what }

## presets

ready-made-settings = إعدادات جاهزة
preset-own = إعداداتك
preset-defaults = الافتراضي
    .help = مناسب لمعظم الأزواج.
preset-many-points = نقاط كثيرة
    .help = ضعف عدد النقاط: نحو ضعف عدد المطابقات، في ضعف الوقت.
preset-little-in-common = القليل المشترك
    .help = نوافذ أكبر لمطابقة المربعات الصغرى: مطابقات أكثر في القواعد الطويلة والمقاييس المختلفة.
preset-zahran-2007 = زهران 2007
    .help = طريقة البحث بقيمها: صورتان بمقياس واحد دون دوران إحداهما عن الأخرى.

## simulate

sample-the-built-in-pair = نموذج: الزوج المدمج
paper-its-geometry-and-angles = البحث: هندسته وزواياه
hard-high-relief-blur-noise = صعب: تضاريس عالية، عدم وضوح، ضجيج
lively-river-traffic-grain-haze = حيّ: نهر، حركة مرور، حبيبات، ضباب
render-this-pair = ولّد هذا الزوج
another-town = مدينة أخرى
the-next-seed = البذرة التالية
a-flight-over-a-synthetic = طيران فوق مشهد اصطناعي. الحقيقة معروفة: تُقارن بها المطابقات والتوجيه، وتظهر الأخطاء بجانب الأخطاء المعيارية.
preset = إعداد مسبق
preview-of-the-left-image = معاينة الصورة اليسرى
preview-of-the-right-image = معاينة الصورة اليمنى
no-preview = لا معاينة: { $message }

## statistics

state-2 = الحالة
truth = الحقيقة
used = مستعملة
wrong = خاطئة
correct = صحيحة
all-matches = جميع المطابقات
gross-errors = الأخطاء الجسيمة
wrong-by-the-truth = الخاطئة بحسب الحقيقة
gross-error = خطأ جسيم
at-an-edge = عند حافة
matches-to-show = المطابقات المعروضة
scroll-sideways-for-more-columns = مرّر جانبيًا لمزيد من الأعمدة ←
choose-all = اختيار الكل
choose-the-matches-that-the = اختيار المطابقات المعروضة في القائمة لرفضها أو استعادتها
table-of-matches = جدول المطابقات
match-2 = رقم المطابقة
number-of-the-match-in = رقم المطابقة بترتيب نقاطها اليسرى.
whether-the-adjustment-used-the = هل استعمل الضبط المطابقة، وما عُمل بها يدويًا.
whether-the-match-is-right = هل المطابقة صحيحة: ضمن 1.5 بكسل من الموضع الذي يُرى فيه السطح، هناك أو عند بكسل مجاور.
cancelled-the-images-stay = أُلغي. الصور باقية: اضغط «تشغيل» لفتحها.
the-images-wait-for-run = لا تُطابق الصور ما دامت علاماتها الإطارية تُقاس: اضغط «تشغيل» لمطابقتها.
cancelled-results-on-the-screen = أُلغي. النتائج على الشاشة باقية. اضغط «تشغيل» أو غيّر إعدادًا للمتابعة.
not-oriented-4 = لم يُوجَّه: { $matches }.

## toolbar

no-lines = لا شيء
all-lines = الكل
show-the-matched-points = إظهار النقاط المطابَقة
unmatched = غير المطابَقة
show-rejected-points-too-marked = إظهار النقاط المرفوضة أيضًا معلّمة بالقاعدة التي رفضتها: اضغط إحداها لترى السبب
lines = الخطوط
pan-and-zoom-both-images = تحريك الصورتين وتكبيرهما معًا (L)
magnifier = المكبّرة
enlarge-what-is-under-the-pointer = تكبير ما تحت المؤشر (M)
previous-point-p = النقطة السابقة (P)
next-point-n = النقطة التالية (N)
whole-images = الصورتان كاملتين
no-left-point-was-matched = لم تطابَق هذه بنقطة يسرى: تبحث هذه الاستراتيجية في الصورة اليمنى نفسها عند النقاط اليسرى.
no-left-point-has-this = ليست هذه النقطة أفضل مرشح لأي نقطة يسرى.
px-window-enlarged = نافذة { $side } × { $side } بكسل، مكبّرة

## state

of-more-there-is-no = {" "}ولا مطابقة في الموضع نفسه لعدد { $lost ->
        [one] رفض واحد آخر
        [two] رفضين آخرين
        [few] { $lost } حالات رفض أخرى
       *[other] { $lost } حالة رفض أخرى
    }.
no-edits-by-hand-apply = لا تنطبق تعديلات يدوية على هذه النتيجة.
kept = بقي: { $join }.
least-squares-matching-confirms-no = لا تؤكد المطابقة بالمربعات الصغرى موضعًا قرب هذا: تختلف النافذتان كثيرًا، أو هما مدارتان إحداهما بالنسبة إلى الأخرى.
matched-then-rejected-by-hand = طوبقت ثم رُفضت يدويًا.
measured-by-hand = قيست يدويًا.
measured-by-hand-2 = مقيسة يدويًا
matches-by-hand = { $number ->
        [one] مطابقة واحدة
        [two] مطابقتان
        [few] { $number } مطابقات
       *[other] { $number } مطابقة
    } { $what ->
        [rejected] مرفوضة
       *[measured] مقيسة
    } يدويًا
step-matches = { $kind ->
        [reject] رفض
       *[restore] استعادة
    } { $matches ->
        [one] مطابقة واحدة
        [two] مطابقتين
        [few] { $matches } مطابقات
       *[other] { $matches } مطابقة
    }
step-add-match = إضافة مطابقة
step-move-match = نقل مطابقة
image-3 = الصورة { $side ->
        [Left] اليسرى
       *[Right] اليمنى
    }:{" "}
matching-2 = المطابقة
decoding-the-left-image = فك ترميز الصورة اليسرى
decoding-the-right-image = فك ترميز الصورة اليمنى
detecting-points-left = كشف النقاط، اليسرى
detecting-points-right = كشف النقاط، اليمنى
describing-points-left = وصف النقاط، اليسرى
describing-points-right = وصف النقاط، اليمنى
estimating-the-offset-of-the = تقدير إزاحة الصورتين
interior-orientation-left = التوجيه الداخلي، اليسرى
interior-orientation-right = التوجيه الداخلي، اليمنى
relative-orientation-2 = التوجيه النسبي
comparing-with-the-truth = المقارنة بالحقيقة
comparing-how-the-photos-lie = مقارنة وضع الصورتين إحداهما إلى الأخرى
looking-where-the-point-may = البحث عن موضع النقطة
loading-the-selected-point = تحميل النقطة المحددة
measure-2 = المقياس
y-parallax = اختلاف المنظر الصادي
weight = الوزن
column-of-the-left-point = عمود النقطة اليسرى؛ مركز البكسل الأيسر العلوي عند 0.5.
row-of-the-left-point = صف النقطة اليسرى.
dissimilarity-of-the-points-by = عدم تشابه النقطتين: بعزوم نافذتيهما، أو 1 ناقص معامل الارتباط، أو بعد واصفيهما. الصغير جيد. وهو فارغ حيث قيست المطابقة يدويًا أو وُضعت من جاراتها.
correlation-of-a-match = الارتباط
correlation-after-least-squares = معامل ارتباط القيم الرمادية بعد المطابقة بالمربعات الصغرى. القريب من 1 جيد.
standard-error-of-the-right = الخطأ المعياري للموضع الأيمن من المطابقة بالمربعات الصغرى، في أسوأ اتجاهيه.
residual-y-parallax-the-distance = متبقي اختلاف المنظر الصادي: المسافة التي يمر بها الشعاعان أحدهما بالآخر، بمقياس الصورة.
redundancy-number-the-share-of = عدد الفائض: نصيب خطأ هذه المطابقة الذي يظهر في متبقيها. قرب 0 لا تراقبها المطابقات الأخرى.
w-statistic-standardised-residual-data = الإحصاءة w: المتبقي المعياري. يرفض تقصّي البيانات ما فوق الحد الذي تضعه α₀ (‏3.29 لقيمة 0.001).
minimal-detectable-bias-mdb-across = أصغر انحياز يمكن كشفه (MDB) عموديًا على الخط القطبي: يُكشف خطأ بهذا القدر باحتمال β₀.
external-reliability-the-largest-effect = الموثوقية الخارجية: أكبر أثر لخطأ غير مكشوف بهذا القدر في مجهول، بأخطائه المعيارية.
weight-in-the-adjustment-0 = الوزن في الضبط؛ 0 حيث رُفضت.
model-coordinate-at-photo-scale = إحداثي النموذج بمقياس الصورة، على امتداد القاعدة.
model-coordinate-at-photo-scale-across = إحداثي النموذج بمقياس الصورة، عموديًا على القاعدة.
model-coordinate-at-photo-scale-upwards = إحداثي النموذج بمقياس الصورة، إلى أعلى؛ تقع الصورة عند سالب البعد الأساسي.

## view

pictures-of-a-pair-while = صور الزوج، أثناء قياس مطابقة
pictures-of-a-pair-while-marking = صور الزوج، أثناء قياس الالعلامات الإطاريةية
moves-the-mark-by = يحرك العلامة 0.1 بكسل؛ ومع Shift بكسلًا واحدًا
goes-to-the-next-mark = ينتقل إلى العلامة التالية
goes-to-the-mark-before = ينتقل إلى العلامة السابقة
measures-the-mark-in-the-middle = يقيس العلامة في وسط الصورة
takes-the-mark-back = يمحو موضع قياس العلامة
pictures-of-a-pair-while-masking = صور الزوج، أثناء تقنيع مساحات
places-a-corner-in-the-middle = يضع ركنًا للمساحة في وسط الصورة
takes-the-last-corner-back = يتراجع عن آخر ركن
step-of-draft = وضع نقطة من المطابقة
step-of-outline = آخر جزء من التحديد
anywhere-while-masking = في أي مكان، أثناء تحديد مساحة
gives-the-outline-up = يتخلى عن التحديد
masks-the-outlined-area = يُقنِّع المساحة المحددة
unmasks-the-outlined-area = يرفع القناع عن المساحة المحددة
outlines-areas-to-be-masked = يحدد مساحات لتقنيعها
pictures-of-a-pair = صور الزوج
takes-the-middle-of-the-picture = يأخذ وسط الصورة للنقطة الأولى
accepts-the-measured-match = يقبل المطابقة المقيسة
goes-to-the-point-in = ينتقل إلى النقطة في الصورة الأخرى
fits-the-point-by-least = يوائم النقطة بالمطابقة بالمربعات الصغرى
selects-the-next-point = يحدد النقطة التالية
selects-the-previous-point = يحدد النقطة السابقة
goes-to-the-other-picture = ينتقل إلى الصورة الأخرى
links-both-pictures-or-no = يربط الصورتين أو يفكهما
shows-the-magnifier-or-no = يُظهر المكبّرة أو يخفيها
chooses-matches-by-rectangles = يختار المطابقات بمستطيلات
adds-a-match-by-measuring = يضيف مطابقة بقياسها
gives-up-or-selects-nothing = يترك، أو لا يحدد شيئًا

## Points and results

candidate-of = غير مطابَقة. هي أفضل مرشح للنقطة اليسرى { COUNT($point) }، وهي مرفوضة.
ratio =
    { $second ->
        [none] بلا مرشح ثان
       *[other] { FIXED($ratio, digits: 3) } من ثاني الأفضل ({ FIXED($second, digits: 4) })
    }
correlation = الارتباط { FIXED($correlation, digits: 4) }، المقياس { FIXED($best, digits: 4) }.
low-correlation = الارتباط { FIXED($correlation, digits: 4) }؛ المسموح { $least } أو أكثر.
good-measure = أفضل مقاييسها { FIXED($best, digits: 4) } دون { $most }، و{ ratio }.
large-measure = أفضل المقاييس { FIXED($best, digits: 4) }؛ المسموح دون { $most }.
ambiguous = أفضل مقاييسها { FIXED($best, digits: 4) } هو { ratio }؛ المسموح حتى { $largest }.
parallax-beside = مرفوضة: يختلف اختلاف منظرها الصادي عنه لأقرب المطابقات بمقدار { FIXED($deviation_px, digits: 2) } بكسل؛ والمسموح { FIXED($allowed_px, digits: 2) } بكسل، وهو التفاوت المسموح أو ثلاثة أمثال تشتتها حيث كان أكثر.
parallax = التفاوت المسموح: { $tolerance } بكسل، أو ثلاثة أمثال تشتت جيرانها حيث كان أكثر.
imprecise = المسموح حتى { $most } بكسل.
distance = البعد { FIXED($best, digits: 4) }، { ratio }.
only-candidate = البعد { FIXED($best, digits: 4) }، وهو المرشح الوحيد المتفق مع هندسة المشهدين.
predicted-match = لم يجد واصفها مطابقة: وضعتها المطابقة بالمربعات الصغرى حيث تتوقعها المطابقات من حولها، الارتباط { FIXED($correlation, digits: 4) }.
clear-candidate = البعد { FIXED($best, digits: 4) }، { ratio }. يتفق مع هندسة المشهدين.
agreeing-candidate = البعد { FIXED($best, digits: 4) }، { ratio }: أكثر من { $largest }، لكنه يتفق مع هندسة المشهدين التي لا تترك إلا قليلًا من المرشحين.
no-geometry =
    البعد { FIXED($best, digits: 4) }، { ratio }. لم توجد هندسة للمشهدين{ $no_geometry ->
        [none] .
       *[other] : { $no_geometry }.
    }
off-line =
    البعد { FIXED($best, digits: 4) }، { ratio }؛ لكنه لا يوافق: { $off_px ->
        [none] المسموح حتى { FIXED($threshold_px, digits: 2) } بكسل من خطه القطبي.
       *[other] يبعد { FIXED($off_px, digits: 2) } بكسل عن خطه القطبي؛ والمسموح حتى { FIXED($threshold_px, digits: 2) } بكسل.
    }
off-place =
    البعد { FIXED($best, digits: 4) }، { ratio }؛ لكنه لا يوافق: { $off_px ->
        [none] المسموح حتى { FIXED($threshold_px, digits: 2) } بكسل من موضعه المتوقع.
       *[other] يبعد { FIXED($off_px, digits: 2) } بكسل عن موضعه المتوقع؛ والمسموح حتى { FIXED($threshold_px, digits: 2) } بكسل.
    }
matched = المطابقات: { COUNT($matches) } من { COUNT($points) } نقطة يسرى
step = الخطوة { $step } من { $steps }: { $stages }
worked = { $matched }، { FIXED($seconds, digits: 2) } ث من العمل.
estimated-focal = بالبعد البؤري المقدَّر من المطابقات: { FIXED($focal_px, digits: 0) } ± { FIXED($error_px, digits: 0) } بكسل. يدخل خطؤه في الأخطاء المعيارية في عمود «الإجمالي». الأطوال بالمليمتر هي لبكسلات قدرها 0.001 مم.
global-test = مجموع مربعات المتبقيات الموزونة على σ₀² المعطاة: مع مطابقات جيدة بين { FIXED($lower, digits: 1) } و{ FIXED($upper, digits: 1) } في 95 من 100 حالة. فوق ذلك: المطابقات أسوأ من σ₀ المعطاة، أو النموذج لا يصح. دون ذلك: σ₀ المعطاة كبيرة.
paper = البحث: جدولاه 2 و3 لزوجه (f = { $focal_mm } مم، البكسل { FIXED($pixel_um, digits: 0) } ميكرومتر، b المفترضة = { $base_mm } مم).
paper-sigma = ‏σ₀ { FIXED($sigma0_mm, digits: 3) } مم = { FIXED($sigma0_px, digits: 1) } بكسل
